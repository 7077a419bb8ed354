// SPDX-License-Identifier: Apache-2.0
//
// RMSE, bands and slopes against closed forms, and that splits of the work change no bit.
//
// The patterns are fixed, so the tests give the same result each time. For other patterns, each
// comparison with a closed form would fail with a probability below 1e-6.

#include "wellstrat/analysis/convergence.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace wellstrat {
namespace {

const RandomGenerator kRandom;

std::vector<ErrorSums> sumsOf(const PointSource& source, const std::string& integrand,
                              const std::vector<uint32_t>& counts, PatternRange patterns) {
    const Integrand f = makeIntegrand(integrand);
    std::vector<ErrorSums> sums(counts.size());
    addErrors(source, {&f}, counts, patterns, sums.data());
    return sums;
}

/// The RMSE of 4000 patterns has a relative standard error of about 1 / sqrt(8000) = 1.1 %.
constexpr uint64_t kPatterns = 4000;
constexpr double kNoise = 0.06;

double rmseOf(const PointSource& source, const std::string& integrand, uint32_t count) {
    return estimateError(sumsOf(source, integrand, {count}, {0, kPatterns})[0], kPatterns).rmse;
}

/// The mean of N independent values has the standard deviation of one, divided by sqrt(N).
TEST(Convergence, RandomPointsHaveTheirStandardDeviation) {
    const PointSourcePtr source = generatorSource(&kRandom);
    for (const uint32_t count : {1u, 10u, 100u}) {
        const double root = std::sqrt(count);
        EXPECT_NEAR(rmseOf(*source, "disk", count) * root, 0.5, 0.5 * kNoise);
        EXPECT_NEAR(rmseOf(*source, "linear", count) * root, std::sqrt(1.0 / 12),
                    std::sqrt(1.0 / 12) * kNoise);
        const double two = std::sqrt(1.0 / 4 - 1.0 / 16);
        EXPECT_NEAR(rmseOf(*source, "disk*disk", count) * root, two, two * kNoise);
    }
}

/// One uniform point in each of N strata: the error of x is a sum of N uniform ones on [0, 1/N), of
/// variance 1 / (12 N^2) each, so the RMSE is N^-1.5 / sqrt(12). This is where N^-1.5 comes from.
TEST(Convergence, StratifiedPointsHaveTheirClosedForm) {
    const double factor = 1 / std::sqrt(12.0);
    for (const uint32_t count : {1u, 4u, 64u}) {
        const double expected = factor * std::pow(count, -1.5);
        EXPECT_NEAR(rmseOf(*jitteredSource(), "linear", count), expected, expected * kNoise);
        EXPECT_NEAR(rmseOf(*sobolSource(SobolRandomization::owen), "linear", count), expected,
                    expected * kNoise);
        EXPECT_NEAR(rmseOf(*generatorSource(nullptr), "linear", count), expected,
                    expected * kNoise);
    }
    const double any = factor * std::pow(77, -1.5);
    EXPECT_NEAR(rmseOf(*jitteredSource(), "linear", 77), any, any * kNoise);
}

/// Guards against errors measured from something else than the integral.
TEST(Convergence, ErrorsOfUnbiasedPointsHaveMeanZero) {
    for (const char* integrand : {"disk", "gaussian", "box-1", "checkerboard-3", "sine-2"}) {
        const ErrorEstimate error = estimateError(
            sumsOf(*generatorSource(nullptr), integrand, {16}, {0, kPatterns})[0], kPatterns);
        EXPECT_LT(std::fabs(error.bias), 5 * error.rmse / std::sqrt(double(kPatterns)))
            << integrand;
    }
}

bool same(const ErrorSums& a, const ErrorSums& b) {
    return a.first.words() == b.first.words() && a.second.words() == b.second.words() &&
           a.fourth.words() == b.fourth.words();
}

TEST(Convergence, SplitsOfThePatternsChangeNoBit) {
    const std::vector<uint32_t> counts{1, 3, 16, 100};
    for (const PointSourcePtr& source : {generatorSource(nullptr), jitteredSource()}) {
        const std::vector<ErrorSums> whole = sumsOf(*source, "disk", counts, {10, 40});
        for (const uint64_t cut : {10u, 11u, 25u, 40u}) {
            const std::vector<ErrorSums> head = sumsOf(*source, "disk", counts, {10, cut});
            std::vector<ErrorSums> parts = sumsOf(*source, "disk", counts, {cut, 40});
            for (std::size_t c = 0; c < counts.size(); ++c) {
                parts[c] += head[c];
                EXPECT_TRUE(same(parts[c], whole[c])) << cut;
            }
        }
    }
}

/// Guards against prefixes that lose or repeat points.
TEST(Convergence, CountsTogetherAreCountsAlone) {
    const std::vector<uint32_t> counts{1, 2, 7, 8, 300};
    for (const PointSourcePtr& source : {generatorSource(nullptr), jitteredSource()}) {
        const std::vector<ErrorSums> together = sumsOf(*source, "triangle", counts, {0, 20});
        for (std::size_t c = 0; c < counts.size(); ++c) {
            const ErrorSums alone = sumsOf(*source, "triangle", {counts[c]}, {0, 20})[0];
            EXPECT_TRUE(same(together[c], alone)) << counts[c];
        }
    }
}

TEST(Convergence, IntegrandsTogetherAreIntegrandsAlone) {
    const Integrand disk = makeIntegrand("disk"), step = makeIntegrand("step");
    const std::vector<uint32_t> counts{4, 5};
    std::vector<ErrorSums> together(4);
    addErrors(*jitteredSource(), {&disk, &step}, counts, {0, 20}, together.data());
    const std::vector<ErrorSums> alone = sumsOf(*jitteredSource(), "step", counts, {0, 20});
    EXPECT_TRUE(same(together[2], alone[0]) && same(together[3], alone[1]));
}

TEST(Convergence, BadArgumentsAreRejected) {
    const Integrand disk = makeIntegrand("disk"), linear = makeIntegrand("linear");
    const PointSourcePtr source = jitteredSource();
    std::vector<ErrorSums> sums(4);
    const auto add = [&](const std::vector<const Integrand*>& integrands,
                         const std::vector<uint32_t>& counts, PatternRange patterns) {
        addErrors(*source, integrands, counts, patterns, sums.data());
    };
    EXPECT_THROW(add({&disk, &linear}, {4}, {0, 1}), std::invalid_argument);
    EXPECT_THROW(add({&disk}, {4, 4}, {0, 1}), std::invalid_argument);
    EXPECT_THROW(add({&disk}, {0, 4}, {0, 1}), std::invalid_argument);
    EXPECT_THROW(add({&disk}, {4}, {0, (uint64_t{1} << 32) + 1}), std::invalid_argument);
}

/// Errors 3 and 1: mean square 5, mean 4th power 41, so a variance of 41 - 25 = 16 for the mean of
/// two, and a factor of exp(1.96 / 2 * 4 / 5).
TEST(Convergence, BandsFollowTheirFormula) {
    ErrorSums sums;
    sums.first += 3 - 1;
    sums.second += 9 + 1;
    sums.fourth += 81 + 1;
    const ErrorEstimate error = estimateError(sums, 2);
    EXPECT_DOUBLE_EQ(error.rmse, std::sqrt(5));
    EXPECT_DOUBLE_EQ(error.bias, 1);
    EXPECT_NEAR(error.high / error.rmse, std::exp(1.959964 / 2 * 0.8), 1e-6);
    EXPECT_NEAR(error.rmse / error.low, std::exp(1.959964 / 2 * 0.8), 1e-6);
    EXPECT_TRUE(std::isnan(estimateError(sums, 1).low));
    EXPECT_EQ(estimateError(ErrorSums(), 2).high, 0);
}

/// Of 400 bands from 100 patterns each, about 95 % hold the true value; fewer than 90 % or more
/// than 98 % have a probability below 1e-4. Guards against bands for another quantity or level.
TEST(Convergence, BandsHoldTheTrueValueAsOftenAsTheySay) {
    const PointSourcePtr source = generatorSource(&kRandom);
    const double expected = std::sqrt(1.0 / 12 / 16);
    unsigned hits = 0;
    for (uint64_t i = 0; i < 400; ++i) {
        const PatternRange patterns{100 * i, 100 * i + 100};
        const ErrorEstimate error =
            estimateError(sumsOf(*source, "linear", {16}, patterns)[0], 100);
        if (error.low <= expected && expected <= error.high) ++hits;
    }
    EXPECT_GT(hits, 360u);
    EXPECT_LT(hits, 393u);
}

TEST(Convergence, SlopesOfPowersAreTheirExponents) {
    const std::vector<uint32_t> counts{1, 4, 16, 64, 256};
    std::vector<double> rmse;
    for (const uint32_t count : counts) rmse.push_back(3 * std::pow(count, -0.75));
    rmse[0] = 100; // before the first count that takes part
    rmse[3] = 0;   // exact by chance
    const SlopeFit fit = fitSlope(counts, rmse, 4);
    EXPECT_NEAR(fit.slope, -0.75, 1e-12);
    EXPECT_NEAR(fit.standardError, 0, 1e-7);
    EXPECT_EQ(fit.points, 3u);
    EXPECT_TRUE(std::isnan(fitSlope(counts, rmse, 256).slope));
}

/// Three points (0, 0), (1, 0), (2, 3) in logarithms: slope 3/2; residuals 1/2, -1, 1/2, so a
/// standard error of sqrt(3/2 / 1 / 2).
TEST(Convergence, SlopesHaveTheErrorOfLeastSquares) {
    const SlopeFit fit = fitSlope({1, 2, 4}, {1, 1, 8}, 1);
    EXPECT_NEAR(fit.slope, 1.5, 1e-12);
    EXPECT_NEAR(fit.standardError, std::sqrt(0.75), 1e-12);
}

/// The claim of the field, on powers of two: -1.5 where smooth, about -0.75 where not.
TEST(Convergence, StratifiedSlopesAreTheKnownOnes) {
    std::vector<uint32_t> counts;
    for (uint32_t count = 16; count <= 1024; count *= 2) counts.push_back(count);
    const auto slope = [&](const PointSource& source, const char* integrand) {
        std::vector<double> rmse;
        for (const ErrorSums& sums : sumsOf(source, integrand, counts, {0, 500})) {
            rmse.push_back(estimateError(sums, 500).rmse);
        }
        return fitSlope(counts, rmse, 1).slope;
    };
    for (const PointSourcePtr& source :
         {generatorSource(nullptr), sobolSource(SobolRandomization::owen)}) {
        EXPECT_NEAR(slope(*source, "gaussian"), -1.45, 0.1);
        EXPECT_NEAR(slope(*source, "disk"), -0.75, 0.06);
    }
    EXPECT_NEAR(slope(*generatorSource(&kRandom), "disk"), -0.5, 0.06);
}

} // namespace
} // namespace wellstrat
