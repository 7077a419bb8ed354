// SPDX-License-Identifier: Apache-2.0
//
// What is computed about slots without a sample, against samples.

#include "bank_search/judge.h"

#include "banks.h"

#include "wellstrat/analysis/convergence.h"
#include "wellstrat/joint_bank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace bank_tests {
namespace {

using namespace wellstrat;

double rmse(const PointSource& source, const Integrand& integrand, uint32_t count,
            uint64_t patterns) {
    ErrorSums sums;
    addErrors(source, {&integrand}, {count}, {0, patterns}, &sums);
    return estimateError(sums, patterns).rmse;
}

/// The judged ratio of slots a and b, and the one of samples that users draw. 20,000 patterns leave
/// the measured ratio a standard error of 0.7 %; five of them are allowed, for a false alarm in
/// 10^6.
void compare(unsigned a, unsigned b, const std::string& name, unsigned digits) {
    constexpr uint64_t kPatterns = 20000;
    Bank bank(2);
    for (unsigned k = 0; k < kDigits; ++k) {
        bank[0][k] = kJointBank[a][k];
        bank[1][k] = kJointBank[b][k];
    }
    const double judged = judge(bank, makeIntegrand(name)).mean[digits];
    const Integrand squared = makeIntegrand(name + "^2");
    const double joint = rmse(*jointSource({a, b}), squared, 1u << digits, kPatterns);
    const double padded = rmse(*generatorSource(nullptr), squared, 1u << digits, kPatterns);
    EXPECT_NEAR(joint / padded / judged, 1, 0.035) << a << ' ' << b << ' ' << name << ' ' << digits;
}

TEST(BankJudge, AgreesWithSamples) {
    compare(0, 1, "disk", 6);
    compare(0, 1, "gaussian", 8);
    compare(2, 13, "edge-30", 7);
    compare(5, 11, "checkerboard-1", 6);
    compare(3, 9, "step", 5);
}

TEST(BankJudge, SlotAgainstItselfIsWorseAndTheBoundHolds) {
    const Integrand disk = makeIntegrand("disk");
    const Columns columns = randomBank(1, 1)[0];
    EXPECT_GT(judge({columns, columns}, disk).mean[8], 2);
    // The bound is on the mean of squares; no ratio of one pair is below it.
    for (uint32_t seed = 1; seed <= 5; ++seed) {
        const Judgement pair = judge(randomBank(2, seed), disk);
        for (unsigned m = 0; m <= kDigits; ++m) {
            EXPECT_GE(pair.mean[m], pair.bound[m] - 1e-9) << m;
            EXPECT_EQ(pair.mean[m], pair.worst[m]);
        }
    }
}

TEST(BankJudge, WithoutADifferenceTheRatioIsOne) {
    const Judgement pair = judge(randomBank(2, 1), makeIntegrand("gaussian"));
    for (unsigned m = 0; m <= 2; ++m) EXPECT_NEAR(pair.mean[m], 1, 1e-9); // 1, 2 and 4 points
}

TEST(BankJudge, RejectsOtherDomains) {
    EXPECT_THROW(judge(randomBank(2, 1), makeIntegrand("disk^2")), std::invalid_argument);
    EXPECT_THROW(judge(randomBank(2, 1), makeIntegrand("step-1d")), std::invalid_argument);
}

} // namespace
} // namespace bank_tests
