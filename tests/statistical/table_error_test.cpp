// SPDX-License-Identifier: Apache-2.0
//
// How far the mean of a coordinate over the first samples of a table lies from 1/2, over all
// digital shifts and tables, against nested uniform scrambling with independent digits. The error
// is known exactly for each table, without any sampling of patterns. Guards against tables that are
// too much alike, and against digits below the stratified ones that are not random.
//
// False alarms: statistics.h; 27 checks.

#include "statistical/statistics.h"
#include "wellstrat/tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {

using namespace statistical;
using namespace wellstrat;

/// The expected squared error. A shift flips the sign of how much the mean of each digit differs
/// from 1/2, each with an even chance, so the errors of the digits are uncorrelated.
double squaredError(unsigned table, unsigned count, Coordinate coordinate) {
    uint32_t ones[24] = {0};
    for (unsigned i = 0; i < count; ++i) {
        const uint32_t value = tableValue(table, i, coordinate);
        for (unsigned digit = 0; digit < 24; ++digit) ones[digit] += value >> (31 - digit) & 1u;
    }
    double sum = 0;
    for (unsigned digit = 0; digit < 24; ++digit) {
        const double error = std::ldexp(ones[digit] / double(count) - 0.5, -int(digit) - 1);
        sum += error * error;
    }
    return sum;
}

// Points that are uniform in strata of 1 / N have a squared error of 1 / (12 N^3). That of a table,
// relative to this, has a variance of 2 (0.75^2 + 0.1875^2 + ...) = 1.2: three quarters come from
// the first digit below the strata, a fourth of it from the next, and so on. The mean over the
// tables is near enough chi-square with the degrees of freedom that give this variance.
TEST(TableError, IsThatOfIndependentDigits) {
    constexpr double kFreedom = 2 / 1.2 * kTableCount;
    for (const Coordinate coordinate : {Coordinate::x, Coordinate::y, Coordinate::z}) {
        for (unsigned count = 16; count <= kTableSize; count *= 2) {
            double sum = 0;
            for (unsigned table = 0; table < kTableCount; ++table) {
                sum += squaredError(table, count, coordinate);
            }
            const double relative = sum / kTableCount * 12 * std::pow(count, 3);
            EXPECT_GE(twoSided(chiSquareTail(relative * kFreedom, kFreedom)), kAlpha)
                << "coordinate " << static_cast<unsigned>(coordinate) << ", " << count
                << " samples: " << relative;
            // What the seed of the tables was chosen for.
            EXPECT_NEAR(relative, 1, 0.07) << count << " samples";
        }
    }
}

} // namespace
