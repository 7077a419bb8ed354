// SPDX-License-Identifier: Apache-2.0
//
// The sum that does not depend on the order of its terms.

#include "wellstrat/analysis/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace wellstrat {
namespace {

/// Of both signs and of all magnitudes from 2^-90 to 2^30.
std::vector<double> someTerms(std::size_t count) {
    std::mt19937_64 engine(7);
    std::vector<double> terms(count);
    for (double& term : terms) {
        const auto mantissa = static_cast<double>(engine() >> 11) * 0x1p-53;
        term = std::ldexp(mantissa - 0.5, static_cast<int>(engine() % 120) - 89);
    }
    return terms;
}

ExactSum sumOf(const std::vector<double>& terms) {
    ExactSum sum;
    for (const double term : terms) sum += term;
    return sum;
}

/// Guards against sums in floating point, whose last bits change with the order.
TEST(ExactSum, DoesNotDependOnTheOrder) {
    std::vector<double> terms = someTerms(1000);
    const ExactSum expected = sumOf(terms);
    std::mt19937 engine(1);
    for (int round = 0; round < 20; ++round) {
        std::shuffle(terms.begin(), terms.end(), engine);
        EXPECT_EQ(sumOf(terms).words(), expected.words());
    }
}

TEST(ExactSum, DoesNotDependOnTheSplit) {
    const std::vector<double> terms = someTerms(1000);
    for (const std::ptrdiff_t cut : {0, 1, 499, 999, 1000}) {
        ExactSum parts = sumOf({terms.begin(), terms.begin() + cut});
        parts += sumOf({terms.begin() + cut, terms.end()});
        EXPECT_EQ(parts.words(), sumOf(terms).words()) << cut;
    }
}

/// Guards against a lost carry or borrow: what goes in comes out, whatever else is there.
TEST(ExactSum, TermsCancelToZero) {
    std::vector<double> terms = someTerms(500);
    for (std::size_t i = 0; i < 500; ++i) terms.push_back(-terms[i]);
    EXPECT_EQ(sumOf(terms).words(), ExactSum().words());
    EXPECT_EQ(sumOf({0x1p30, 0x1p-192, -0x1p30}).value(), 0x1p-192);
    EXPECT_EQ(sumOf({-0x1p-192, 0x1p-64, -0x1p-64}).value(), -0x1p-192);
    EXPECT_EQ(sumOf({0x1p-130, -0x1p-128, 0x1p-1}).value(), 0.5);
}

TEST(ExactSum, GivesSingleTermsBack) {
    for (const double term : {0.0, 1.0, -1.0, 0.1, -0.3, 0x1p-140, 0x1.fffffffffffffp30, -1e-30}) {
        EXPECT_EQ(sumOf({term}).value(), term);
    }
}

TEST(ExactSum, DropsWhatIsBelowItsUnit) {
    EXPECT_EQ(sumOf({0x1p-193, -0x1p-193, 0x1p-300, 5e-324}).words(), ExactSum().words());
    EXPECT_EQ(sumOf({0x1.8p-192}).value(), 0x1p-192);
}

TEST(ExactSum, HoldsAsManyTermsAsPromised) {
    ExactSum sum;
    sum += 0x1.fffffffffffffp30;
    for (int doubling = 0; doubling < 32; ++doubling) sum += ExactSum(sum.words());
    EXPECT_EQ(sum.value(), 0x1.fffffffffffffp62);
}

TEST(ExactSum, RejectsWhatItCannotHold) {
    ExactSum sum;
    for (const double term : {0x1p31, -0x1p31, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(sum += term, std::range_error) << term;
    }
    EXPECT_EQ(sum.words(), ExactSum().words());
}

} // namespace
} // namespace wellstrat
