// SPDX-License-Identifier: Apache-2.0
//
// The certificate: complete, repeatable, and without a violation.

#include "wellstrat/analysis/certificate.h"

#include "wellstrat/tables.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace wellstrat {
namespace {

using Lines = std::vector<CertificateLine>;

// Debug builds check a part of the tables and few patterns.
#ifdef NDEBUG
constexpr unsigned kLastTable = kTableCount - 1;
constexpr unsigned kPatterns = 100;
#else
constexpr unsigned kLastTable = 11;
constexpr unsigned kPatterns = 2;
#endif

void expectNoViolation(const Lines& lines) {
    for (const CertificateLine& line : lines) {
        EXPECT_EQ(line.violations, 0u) << line.promise << ": " << line.firstViolation;
        EXPECT_EQ(line.firstViolation, "") << line.promise;
        EXPECT_GT(line.intervals, 0u) << line.promise;
        EXPECT_FALSE(line.subject.empty()) << line.promise;
    }
}

/// Shapes and intervals of all aligned blocks of 2^m of 4096 points, m = 0..12, by the binomial
/// formula in nets.h.
constexpr uint64_t kStrata = 13 * 4096;
constexpr uint64_t kPlane = 91 * 4096;               // sum of m + 1
constexpr uint64_t kSpace = 4096 + 364 * (4096 / 2); // sum of m (m + 1) / 2, two points each
constexpr uint64_t kBoxes = 84 * 4096;               // sum of (k + 1) (k + 2) / 2, k = 0..6

void expectCounts(const Lines& lines, uint64_t sets) {
    ASSERT_GE(lines.size(), 6u);
    for (unsigned d = 0; d < 3; ++d) EXPECT_EQ(lines[d].intervals, sets * kStrata);
    EXPECT_EQ(lines[3].intervals, sets * kPlane);
    EXPECT_EQ(lines[4].intervals, sets * kSpace);
    EXPECT_EQ(lines[5].intervals, sets * kBoxes);
}

TEST(Certificate, TablesKeepAllPromises) {
    const Lines lines = certifyTables(0, kLastTable);
    EXPECT_EQ(lines.size(), 7u);
    expectNoViolation(lines);
    expectCounts(lines, kLastTable + 1);
}

// Also in Debug builds, tables from the middle and the end.
TEST(Certificate, ARangeOfTables) {
    const Lines lines = certifyTables(190, 192);
    expectNoViolation(lines);
    expectCounts(lines, 3);
    expectNoViolation(certifyTables(kTableCount - 1, kTableCount - 1));
}

TEST(Certificate, PatternsKeepAllPromises) {
    const Lines lines = certifyPatterns(kPatterns);
    EXPECT_EQ(lines.size(), 10u);
    expectNoViolation(lines);
    expectCounts(lines, (kPatterns + 8) * 3); // 8 special patterns, 3 blocks each
}

constexpr unsigned kDomains = 17; // the slots, and none

TEST(Certificate, LongKeepsAllPromises) {
    const Lines lines = certifyLong(kPatterns);
    EXPECT_EQ(lines.size(), 8u);
    expectNoViolation(lines);
    expectCounts(lines, (kPatterns + kDomains) * 2);
    EXPECT_EQ(lines[6].intervals, (kPatterns + kDomains) * 2 * 4096);
    expectNoViolation(certifyLong(0, 77));
}

TEST(Certificate, BlueKeepsAllPromises) {
    const Lines lines = certifyBlue(kPatterns);
    EXPECT_EQ(lines.size(), 10u);
    expectNoViolation(lines);
    expectCounts(lines, kPatterns + kDomains);
    uint64_t strata = 0; // of runs of 2^k samples, k + 2a = 2a..12
    for (unsigned i = 0; i < kPatterns + kDomains; ++i) strata += (13 - 2 * (1 + i % 6)) * 4096;
    EXPECT_EQ(lines[9].intervals, strata);
    EXPECT_GT(lines[8].intervals, 4 * strata);
    expectNoViolation(certifyBlue(0, 77));
}

TEST(Certificate, OtherSeedsAndNoRandomPatterns) {
    expectNoViolation(certifyPatterns(1, 77));
    expectNoViolation(certifyPatterns(0));
}

TEST(Certificate, RangesThatDoNotExistAreRefused) {
    EXPECT_THROW(certifyTables(3, 2), std::invalid_argument);
    EXPECT_THROW(certifyTables(0, kTableCount), std::invalid_argument);
    try {
        certifyTables(5, 400);
        FAIL() << "no exception";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "tables 5 to 400 are asked for; accepted are ranges within 0 to 383");
    }
}

TEST(Certificate, ProgressGrowsToOne) {
    double last = 0;
    const auto progress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    certifyTables(10, 12, progress);
    EXPECT_EQ(last, 1.0);
    last = 0;
    certifyPatterns(1, 1, progress);
    EXPECT_EQ(last, 1.0);
    last = 0;
    certifyLong(1, 1, progress);
    EXPECT_EQ(last, 1.0);
    last = 0;
    certifyBlue(1, 1, progress);
    EXPECT_EQ(last, 1.0);
}

} // namespace
} // namespace wellstrat
