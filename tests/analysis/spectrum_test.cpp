// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/spectrum.h"

#include "analysis/measured_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace wellstrat {
namespace {

using test::makeUnitPoints;
using test::owenPoints;
using test::randomUnitPoints;
using test::sobolPoints;
using test::unitPoints;

constexpr double kPi = 3.14159265358979323846;

std::complex<double> directSum(const UnitPoints& points, int fx, int fy) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < points.count(); ++i) {
        const double turns = fx * points.coordinate(0)[i] + fy * points.coordinate(1)[i];
        sum += std::polar(1.0, -2 * kPi * turns);
    }
    return sum;
}

Periodogram periodogramOf(const UnitPoints& points, int maxFrequency) {
    Periodogram periodogram(maxFrequency);
    periodogram.add(points);
    return periodogram;
}

/// Within the documented error of the sums. Points at the border of the square are among them.
TEST(Periodogram, IsTheDefinition) {
    const UnitPoints inner = randomUnitPoints(300, 2, 1);
    const UnitPoints points = makeUnitPoints(304, 2, [&](std::size_t i, unsigned d) {
        if (i < 300) return inner.coordinate(d)[i];
        return ((i >> d) & 1) == 0 ? 0.0 : std::nextafter(1.0, 0.0);
    });
    const auto count = static_cast<double>(points.count());
    for (const int highest : {1, 2, 5, 16, 37}) {
        const Periodogram found = periodogramOf(points, highest);
        for (int fy = -highest; fy <= highest; ++fy) {
            for (int fx = -highest; fx <= highest; ++fx) {
                const double amplitude = std::abs(directSum(points, fx, fy));
                EXPECT_NEAR(std::sqrt(found.power(fx, fy) * count), amplitude, 1e-11 * count)
                    << fx << " " << fy << " of " << highest;
            }
        }
    }
}

TEST(Periodogram, HighFrequencies) {
    const UnitPoints points = unitPoints(owenPoints(10, 2, 3));
    const Periodogram found = periodogramOf(points, 511);
    for (const auto& [fx, fy] :
         {std::pair{511, 511}, {-511, 511}, {511, 0}, {-333, 17}, {1, 499}}) {
        EXPECT_NEAR(std::sqrt(found.power(fx, fy) * 1024), std::abs(directSum(points, fx, fy)),
                    1e-11 * 1024);
    }
}

TEST(Periodogram, IsTheMeanOfRealizations) {
    Periodogram both(20);
    const UnitPoints a = randomUnitPoints(100, 2, 1), b = randomUnitPoints(50, 2, 2);
    both.add(a);
    both.add(b);
    EXPECT_EQ(both.realizations(), 2u);
    EXPECT_NEAR(both.power(3, -4),
                (std::norm(directSum(a, 3, -4)) / 100 + std::norm(directSum(b, 3, -4)) / 50) / 2,
                1e-9);
    EXPECT_EQ(both.power(3, -4), both.power(-3, 4));
    EXPECT_NEAR(both.power(0, 0), 75, 1e-9);
}

/// 8 x 8 points: all power at the multiples of 8.
TEST(Periodogram, OfALattice) {
    const Periodogram found = periodogramOf(makeUnitPoints(64, 2,
                                                           [](std::size_t i, unsigned d) {
                                                               const std::size_t at =
                                                                   d == 0 ? i % 8 : i / 8;
                                                               return (double(at) + 0.5) / 8;
                                                           }),
                                            20);
    for (int fy = 0; fy <= 20; ++fy) {
        for (int fx = -20; fx <= 20; ++fx) {
            const bool multiple = fx % 8 == 0 && fy % 8 == 0;
            EXPECT_NEAR(found.power(fx, fy), multiple ? 64 : 0, 1e-8) << fx << " " << fy;
        }
    }
    EXPECT_NEAR(highestPeak(found).power, 64, 1e-8);
}

/// 100 realizations: the power of a frequency is the mean of 100 exponential variables. The mean
/// over a ring of n frequencies has a standard error of 0.1 / sqrt(n). At six of them, 40 rings
/// fail for no reason once in 10^7 runs; the anisotropy of n >= 60 frequencies is known to
/// 4.34 sqrt(2 / n) < 0.8 dB, at five of which 20 rings fail once in 10^5 runs.
TEST(RadialSpectrum, OfIndependentPoints) {
    Periodogram periodogram(40);
    for (uint32_t seed = 0; seed < 100; ++seed) periodogram.add(randomUnitPoints(500, 2, seed));
    const RadialSpectrum radial = radialSpectrum(periodogram);
    ASSERT_EQ(radial.mean.size(), 41u);
    for (unsigned r = 1; r <= 40; ++r) {
        EXPECT_NEAR(radial.mean[r], 1, 6 * 0.1 / std::sqrt(kPi * r)) << r;
        if (r < 20) continue;
        EXPECT_NEAR(radial.anisotropyDb[r], -20, 5 * 0.8) << r;
    }
}

/// Ring 1 holds (1, 0), (0, 1), (1, 1), (-1, 1); of points on the diagonal, the last has all power.
TEST(RadialSpectrum, RingsAndVariance) {
    const UnitPoints diagonal =
        makeUnitPoints(64, 2, [](std::size_t i, unsigned) { return double(i) / 64; });
    const RadialSpectrum radial = radialSpectrum(periodogramOf(diagonal, 3));
    EXPECT_NEAR(radial.mean[1], 64 / 4.0, 1e-9);
    EXPECT_NEAR(radial.anisotropyDb[1], decibels(4), 1e-9); // variance 64^2 / 4
    EXPECT_EQ(radial.mean[0], 0);
}

TEST(RadialSpectrum, WithoutPowerIsTheFloor) {
    const RadialSpectrum radial = radialSpectrum(Periodogram(3));
    for (unsigned r = 0; r <= 3; ++r) EXPECT_EQ(radial.anisotropyDb[r], kFloorDb);
    EXPECT_EQ(decibels(0), kFloorDb);
    EXPECT_NEAR(decibels(100), 20, 1e-12);
}

/// A missing scramble: all realizations are the same, and their spikes do not average out.
TEST(HighestPeak, SeesAMissingScramble) {
    Periodogram scrambled(64), same(64);
    for (uint32_t seed = 0; seed < 32; ++seed) {
        scrambled.add(unitPoints(owenPoints(10, 2, seed)));
        same.add(unitPoints(sobolPoints(10, 2)));
    }
    EXPECT_LT(highestPeak(scrambled).power, 8);
    EXPECT_GT(highestPeak(same).power, 100);
}

TEST(Periodogram, RejectsWhatItCannotDo) {
    EXPECT_THROW(Periodogram(0), PointError);
    EXPECT_THROW(Periodogram(Periodogram::kMaxFrequency + 1), PointError);
    EXPECT_THROW(periodogramOf(randomUnitPoints(4, 3, 1), 4), PointError);
}

} // namespace
} // namespace wellstrat
