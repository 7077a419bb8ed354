// SPDX-License-Identifier: Apache-2.0
//
// What `wellstrat verify` does with a certificate that is broken: the command with checks that find
// what they are told to.

#include "tools/wellstrat/commands.h"
#include "wellstrat/analysis/certificate.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <gtest/gtest.h>

#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// What the parts of the certificate find, in their order.
CertificateLine found[4];

const CertificateLine kHolds{"stratified", "a subject", 12, 0, ""};
const CertificateLine kViolated{"stratified", "a subject", 12, 3, "interval 7 holds 2, not 1"};

/// What the command prints, and its exit code.
std::string verify(int& exitCode, const char* arguments) {
    CLI::App app;
    cli::addVerify(app, exitCode);
    testing::internal::CaptureStdout();
    app.parse(arguments);
    return testing::internal::GetCapturedStdout();
}

} // namespace

std::vector<CertificateLine> certifyTables(unsigned, unsigned, const CertificateProgress&) {
    return {kHolds, found[0]};
}
std::vector<CertificateLine> certifyPatterns(unsigned, uint32_t, const CertificateProgress&) {
    return {kHolds, found[1]};
}
std::vector<CertificateLine> certifyLong(unsigned, uint32_t, const CertificateProgress&) {
    return {kHolds, found[2]};
}
std::vector<CertificateLine> certifyBlue(unsigned, uint32_t, const CertificateProgress&) {
    return {kHolds, found[3]};
}

namespace {

TEST(Verify, AViolationAnywhereIsExitCodeOne) {
    for (CertificateLine& violated : found) {
        for (CertificateLine& line : found) line = kHolds;
        violated = kViolated;
        int exitCode = 0;
        const std::string text = verify(exitCode, "verify");
        EXPECT_EQ(exitCode, 1);
        EXPECT_NE(text.find("VIOLATED"), std::string::npos) << text;
        EXPECT_NE(text.find("first: interval 7 holds 2, not 1"), std::string::npos) << text;
        EXPECT_EQ(text.find("all promises hold"), std::string::npos) << text;
        exitCode = 0;
        const std::string json = verify(exitCode, "verify --json");
        EXPECT_EQ(exitCode, 1);
        EXPECT_NE(json.find("\"passed\": false"), std::string::npos) << json;
    }
}

TEST(Verify, NoViolationIsExitCodeZero) {
    for (CertificateLine& line : found) line = kHolds;
    int exitCode = 0;
    EXPECT_NE(verify(exitCode, "verify").find("all promises hold"), std::string::npos);
    EXPECT_EQ(exitCode, 0);
}

} // namespace
} // namespace stream1
} // namespace wellstrat
