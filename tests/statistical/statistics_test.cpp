// SPDX-License-Identifier: Apache-2.0
//
// The tools of the other tests: tail probabilities against published values.

#include "statistical/statistics.h"

#include <gtest/gtest.h>

namespace {

using namespace statistical;

// Abramowitz and Stegun 1964, tables 26.7 and 26.8.
TEST(Statistics, ChiSquareTailMatchesPublishedValues) {
    EXPECT_NEAR(chiSquareTail(3.84146, 1), 0.05, 1e-6);
    EXPECT_NEAR(chiSquareTail(18.3070, 10), 0.05, 1e-6);
    EXPECT_NEAR(chiSquareTail(2.55821, 10), 0.99, 1e-6);
    EXPECT_NEAR(chiSquareTail(149.449, 100), 0.001, 1e-6);
    EXPECT_NEAR(chiSquareTail(2, 2), std::exp(-1.0), 1e-12);
}

// Wilson and Hilferty 1931: the cube root is close to normal.
TEST(Statistics, ChiSquareTailIsRightForManyCells) {
    const double freedom = 262143;
    for (double z : {-5.0, -1.0, 0.0, 1.0, 6.0}) {
        const double spread = 2 / (9 * freedom);
        const double x = freedom * std::pow(1 - spread + z * std::sqrt(spread), 3);
        const double normalUpper = std::erfc(z / std::sqrt(2.0)) / 2;
        EXPECT_NEAR(chiSquareTail(x, freedom) / normalUpper, 1, 1e-3) << z;
    }
}

TEST(Statistics, NormalTailIsTwoSided) {
    EXPECT_NEAR(normalTail(1.959964), 0.05, 1e-7);
    EXPECT_NEAR(normalTail(-6), 1.973175e-9, 1e-14);
}

TEST(Statistics, CountsThatAreTooEqualFailToo) {
    EXPECT_LT(uniformP(std::vector<uint32_t>(1000, 100)), kAlpha);
    EXPECT_LT(uniformP({100, 300}), kAlpha);
    EXPECT_GT(uniformP({100, 110}), 0.1);
}

} // namespace
