// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/geometry.h"

#include "analysis/measured_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wellstrat {
namespace {

using test::makeUnitPoints;
using test::randomUnitPoints;

constexpr double kPi = 3.14159265358979323846;

double distance(const UnitPoints& points, std::size_t i, std::size_t j, Topology topology) {
    double sum = 0;
    for (unsigned d = 0; d < points.dims(); ++d) {
        const double gap = points.coordinate(d)[i] - points.coordinate(d)[j];
        double square = gap * gap;
        if (topology == Topology::torus) {
            square = std::min({square, (gap - 1) * (gap - 1), (gap + 1) * (gap + 1)});
        }
        sum += square;
    }
    return std::sqrt(sum);
}

std::vector<double> allNearest(const UnitPoints& points, Topology topology) {
    std::vector<double> nearest(points.count(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.count(); ++i) {
        for (std::size_t j = 0; j < points.count(); ++j) {
            if (i != j) nearest[i] = std::min(nearest[i], distance(points, i, j, topology));
        }
    }
    return nearest;
}

/// side^dims points, each in the middle of its cell.
UnitPoints lattice(std::size_t side, unsigned dims) {
    std::size_t count = 1;
    for (unsigned d = 0; d < dims; ++d) count *= side;
    return makeUnitPoints(count, dims, [=](std::size_t i, unsigned d) {
        for (; d > 0; --d) i /= side;
        return (static_cast<double>(i % side) + 0.5) / static_cast<double>(side);
    });
}

/// Points in one corner, which leave most cells empty.
UnitPoints crowdedPoints(std::size_t count, unsigned dims) {
    return makeUnitPoints(count, dims, [=](std::size_t i, unsigned d) {
        return std::ldexp(hashPair(1, static_cast<uint32_t>(i) * dims + d), i % 5 == 0 ? -32 : -42);
    });
}

TEST(NearestDistances, AreTheLeastOfAllDistances) {
    for (const unsigned dims : {1u, 2u, 3u, 5u}) {
        for (const std::size_t count : {2u, 3u, 4u, 9u, 10u, 100u, 333u}) {
            for (const UnitPoints& points :
                 {randomUnitPoints(count, dims, 7), crowdedPoints(count, dims)}) {
                for (const Topology topology : {Topology::cube, Topology::torus}) {
                    const std::vector<double> expected = allNearest(points, topology);
                    double mean = 0;
                    for (const double x : expected) mean += x / static_cast<double>(count);
                    const NearestDistances found = nearestDistances(points, topology);
                    EXPECT_NEAR(found.minimum, *std::min_element(expected.begin(), expected.end()),
                                1e-15);
                    EXPECT_NEAR(found.mean, mean, 1e-13) << dims << " dimensions, " << count;
                }
            }
        }
    }
}

TEST(NearestDistances, OfALattice) {
    for (unsigned dims = 1; dims <= 3; ++dims) {
        for (const Topology topology : {Topology::cube, Topology::torus}) {
            const NearestDistances found = nearestDistances(lattice(8, dims), topology);
            EXPECT_NEAR(found.minimum, 0.125, 1e-12);
            EXPECT_NEAR(found.mean, 0.125, 1e-12);
        }
    }
}

/// On the torus (0.05, 0.5) and (0.95, 0.5) are neighbors.
TEST(NearestDistances, TheTorusWraps) {
    const UnitPoints points = makeUnitPoints(
        2, 2, [](std::size_t i, unsigned d) { return d == 1 ? 0.5 : 0.05 + 0.9 * double(i); });
    EXPECT_NEAR(nearestDistances(points, Topology::cube).minimum, 0.9, 1e-15);
    EXPECT_NEAR(nearestDistances(points, Topology::torus).minimum, 0.1, 1e-15);
}

TEST(NearestDistances, SeeADuplicatedPoint) {
    const UnitPoints once = randomUnitPoints(1000, 3, 1);
    const UnitPoints twice = makeUnitPoints(
        1001, 3, [&](std::size_t i, unsigned d) { return once.coordinate(d)[i == 1000 ? 17 : i]; });
    for (const Topology topology : {Topology::cube, Topology::torus}) {
        EXPECT_GT(nearestDistances(once, topology).minimum, 0);
        EXPECT_EQ(nearestDistances(twice, topology).minimum, 0);
    }
}

TEST(NearestDistances, OfOnePointAreInfinite) {
    EXPECT_TRUE(std::isinf(nearestDistances(randomUnitPoints(1, 2, 1), Topology::torus).minimum));
}

/// The mean distance of independent points in the plane is 1 / (2 sqrt(N)): Clark, Evans 1954,
/// "Distance to nearest neighbor as a measure of spatial relationships", Ecology 35, 445-453. Its
/// standard error there is 0.26136 / N. At six of them one run in 10^9 would fail for no reason.
TEST(NearestDistances, MeanOfIndependentPoints) {
    constexpr std::size_t n = 10000;
    const double mean = nearestDistances(randomUnitPoints(n, 2, 3), Topology::torus).mean;
    EXPECT_NEAR(mean, 0.5 / std::sqrt(double{n}), 6 * 0.26136 / n);
}

TEST(LargestMinimumDistance, IsThatOfTheDensestPacking) {
    // A hexagonal lattice whose cell of two points is 1 x sqrt(3), a cubic one of four points.
    EXPECT_NEAR(largestMinimumDistance(100, 1), 0.01, 1e-15);
    EXPECT_NEAR(largestMinimumDistance(2, 2) * std::sqrt(std::sqrt(3.0)), 1, 1e-15);
    EXPECT_NEAR(largestMinimumDistance(4, 3), std::sqrt(0.5), 1e-15);
    EXPECT_THROW(largestMinimumDistance(4, 4), PointError);
    EXPECT_THROW(largestMinimumDistance(0, 2), PointError);
}

TEST(PairCorrelation, CountsAllPairsOnce) {
    constexpr unsigned bins = 20;
    for (unsigned dims = 1; dims <= 3; ++dims) {
        for (const std::size_t count : {2u, 5u, 64u, 200u}) {
            for (const double range : {0.07, 0.2, 0.5}) {
                const UnitPoints points = randomUnitPoints(count, dims, 5);
                std::vector<double> pairs(bins);
                for (std::size_t i = 0; i < count; ++i) {
                    for (std::size_t j = 0; j < count; ++j) {
                        const double bin = distance(points, i, j, Topology::torus) / range * bins;
                        if (i != j && bin < bins) ++pairs[static_cast<std::size_t>(bin)];
                    }
                }
                const PairCorrelation found = pairCorrelation(points, range, bins);
                ASSERT_EQ(found.values.size(), bins);
                EXPECT_NEAR(found.step, range / bins, 1e-15);
                for (unsigned k = 0; k < bins; ++k) {
                    const double inner = k * range / bins, outer = (k + 1) * range / bins;
                    const double ball[] = {2 * (outer - inner),
                                           kPi * (outer * outer - inner * inner),
                                           4 * kPi / 3 * (std::pow(outer, 3) - std::pow(inner, 3))};
                    const double all = double(count) * double(count - 1) * ball[dims - 1];
                    EXPECT_NEAR(found.values[k] * all, pairs[k], 1e-6) << dims << " " << count;
                }
            }
        }
    }
}

/// No pair of a lattice is closer than its step.
TEST(PairCorrelation, OfALattice) {
    const PairCorrelation found = pairCorrelation(lattice(32, 2), 2.0 / 32, 20);
    for (unsigned k = 0; k < 9; ++k) EXPECT_EQ(found.values[k], 0);
    EXPECT_GT(found.values[9] + found.values[10], 1); // the step itself, as it is rounded
}

/// About 6.3 million pairs in 10 bins, the smallest of which expects 63,000: a standard deviation
/// of 1 / sqrt(31,500). At seven of them, one run in 10^10 would fail for no reason.
TEST(PairCorrelation, IsOneForIndependentPoints) {
    const PairCorrelation found = pairCorrelation(randomUnitPoints(20000, 2, 11), 0.0707, 10);
    for (const double value : found.values) EXPECT_NEAR(value, 1, 7 / std::sqrt(31400.0));
}

TEST(PairCorrelation, SeesDuplicatedPoints) {
    const UnitPoints once = randomUnitPoints(500, 2, 1);
    const UnitPoints twice = makeUnitPoints(
        1000, 2, [&](std::size_t i, unsigned d) { return once.coordinate(d)[i / 2]; });
    const double range = usualPairRange(1000, 2);
    EXPECT_LT(pairCorrelation(once, range, 64).values[0], 5);
    EXPECT_GT(pairCorrelation(twice, range, 64).values[0], 20);
}

TEST(PairCorrelation, RejectsWhatItCannotDo) {
    const UnitPoints points = randomUnitPoints(8, 2, 1);
    EXPECT_THROW(pairCorrelation(points, 0.51, 8), PointError);
    EXPECT_THROW(pairCorrelation(points, 0, 8), PointError);
    EXPECT_THROW(pairCorrelation(points, std::nan(""), 8), PointError);
    EXPECT_THROW(pairCorrelation(points, 0.5, 0), PointError);
    EXPECT_THROW(pairCorrelation(randomUnitPoints(1, 2, 1), 0.5, 8), PointError);
    EXPECT_THROW(pairCorrelation(randomUnitPoints(8, 4, 1), 0.5, 8), PointError);
}

} // namespace
} // namespace wellstrat
