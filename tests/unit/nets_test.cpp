// SPDX-License-Identifier: Apache-2.0
//
// The net checks against a definition-by-definition count, on sets with known answers, and on
// sets with a single fault.

#include "wellstrat/analysis/nets.h"

#include "property/point_sets.h"
#include "wellstrat/owen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace wellstrat::test {
namespace {

/// Counts as the definition of a net says, one interval after the other.
class BruteForce {
public:
    BruteForce(const RawPoints& points, std::size_t first, std::size_t end)
        : points_(points), first_(first), end_(end) {}

    /// For (t,m,s)-nets with m digits of `base`.
    NetReport count(unsigned base, unsigned m, unsigned t) const {
        NetReport report;
        std::vector<unsigned> digits(points_.dims);
        forEachShape(digits, 0, m - t, [&] {
            std::vector<unsigned> corner(points_.dims);
            forEachCorner(base, digits, corner, 0, [&] {
                ++report.intervals;
                report.violations += inside(base, digits, corner) != std::pow(base, t);
            });
        });
        return report;
    }

private:
    using Visit = std::function<void()>;

    void forEachShape(std::vector<unsigned>& digits, unsigned dim, unsigned left,
                      const Visit& visit) const {
        if (dim + 1 == points_.dims) {
            digits[dim] = left;
            return visit();
        }
        for (digits[dim] = 0; digits[dim] <= left; ++digits[dim]) {
            forEachShape(digits, dim + 1, left - digits[dim], visit);
        }
    }

    void forEachCorner(unsigned base, const std::vector<unsigned>& digits,
                       std::vector<unsigned>& corner, unsigned dim, const Visit& visit) const {
        if (dim == points_.dims) return visit();
        for (corner[dim] = 0; corner[dim] < std::pow(base, digits[dim]); ++corner[dim]) {
            forEachCorner(base, digits, corner, dim + 1, visit);
        }
    }

    double inside(unsigned base, const std::vector<unsigned>& digits,
                  const std::vector<unsigned>& corner) const {
        double found = 0;
        for (std::size_t i = first_; i < end_; ++i) {
            bool in = true;
            for (unsigned d = 0; d < points_.dims && in; ++d) {
                const double scaled = points_.at(i, d) * 0x1p-32 * std::pow(base, digits[d]);
                in = scaled >= corner[d] && scaled < corner[d] + 1.0;
            }
            found += in;
        }
        return found;
    }

    const RawPoints& points_;
    const std::size_t first_, end_;
};

/// Sets from very good to very bad: nets, nets with a few moved points, random points.
std::vector<RawPoints> variedSets(unsigned m, unsigned dims) {
    std::vector<RawPoints> sets{randomPoints(m, dims, 7)};
    if (dims > 3) return sets;
    for (const RawPoints& net : {sobolPoints(m, dims), hammersleyPoints(m, dims)}) {
        sets.push_back(net);
        for (unsigned fault = 0; fault < 3; ++fault) {
            RawPoints faulty = net;
            faulty.at(fault % net.count(), fault % dims) ^= 0x80000000u >> fault;
            sets.push_back(faulty);
        }
    }
    return sets;
}

void expectSameCounts(const NetReport& report, const NetReport& expected) {
    EXPECT_EQ(report.intervals, expected.intervals);
    EXPECT_EQ(report.violations, expected.violations);
    EXPECT_EQ(report.firstViolation.empty(), expected.holds());
}

std::string errorOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const NetError& error) {
        return error.what();
    }
    return "no error";
}

PointSet fromFloat(float value) {
    const float values[] = {0.0f, 0.25f, 0.5f, value};
    return PointSet::fromFloats(values, 2, 2);
}

// Guards against a shape that is left out or counted twice, and against wrong digit positions.
TEST(Nets, CountsEqualBruteForce) {
    for (unsigned dims = 1; dims <= PointSet::kMaxDimensions; ++dims) {
        for (unsigned m = 0; m <= (dims <= 3 ? 6u : 4u); ++m) {
            for (const RawPoints& points : variedSets(m, dims)) {
                const BruteForce brute(points, 0, points.count());
                for (unsigned t = 0; t <= m; ++t) {
                    expectSameCounts(checkNet(points.set(), t), brute.count(2, m, t));
                }
                for (unsigned t = 0; m % 2 == 0 && t <= m / 2; ++t) {
                    expectSameCounts(checkNet(points.set(), t, NetBase::four),
                                     brute.count(4, m / 2, t));
                }
            }
        }
    }
}

TEST(Nets, TValueIsTheSmallestThatBruteForceAccepts) {
    for (unsigned dims = 1; dims <= 4; ++dims) {
        for (unsigned m = 0; m <= 5; ++m) {
            for (const RawPoints& points : variedSets(m, dims)) {
                const BruteForce brute(points, 0, points.count());
                unsigned t = 0;
                while (!brute.count(2, m, t).holds()) ++t;
                EXPECT_EQ(tValue(points.set()), t);
            }
        }
    }
}

// Guards against blocks that are left out or mixed up.
TEST(Nets, SequenceCountsEqualBruteForceOverAllBlocks) {
    constexpr unsigned kLongest = 5;
    for (const unsigned base : {2u, 4u}) {
        const unsigned bits = base / 2;
        for (const RawPoints& points : variedSets(kLongest, 3)) {
            NetReport expected;
            for (unsigned m = 0; m * bits <= kLongest; ++m) {
                const std::size_t size = std::size_t{1} << (m * bits);
                for (std::size_t first = 0; first < points.count(); first += size) {
                    expected +=
                        BruteForce(points, first, first + size).count(base, m, std::min(1u, m));
                }
            }
            const NetReport report = checkSequence(points.set(), 1, static_cast<NetBase>(base));
            EXPECT_EQ(report.intervals, expected.intervals);
            EXPECT_EQ(report.violations, expected.violations);
        }
    }
}

// Niederreiter 1987: the Sobol' sequence has t = sum of (degree of polynomial - 1), which is 0, 0
// and 1 for the first 1, 2 and 3 dimensions; the Hammersley set over it needs one dimension less.
TEST(Nets, SobolAndHammersleyHaveTheirKnownT) {
    for (unsigned m = 0; m <= 14; ++m) {
        EXPECT_EQ(tValue(sobolPoints(m, 1).set()), 0u);
        EXPECT_EQ(tValue(sobolPoints(m, 2).set()), 0u);
        EXPECT_LE(tValue(sobolPoints(m, 3).set()), 1u);
        EXPECT_EQ(tValue(hammersleyPoints(m, 3).set()), 0u);
    }
    EXPECT_EQ(tValueOfSequence(sobolPoints(10, 2).set()), 0u);
    EXPECT_EQ(tValueOfSequence(sobolPoints(10, 3).set()), 1u);
    // A net of the whole is no sequence: the first half of i / N fills half of the interval.
    EXPECT_EQ(tValueOfSequence(hammersleyPoints(10, 2).set()), 9u);
}

// A grid of 2^a x 2^a has only 2^a columns, so intervals are at most a digits wide on each side.
TEST(Nets, RegularGridsHaveLargeT) {
    for (unsigned a = 1; a <= 5; ++a) {
        const RawPoints grid = makePoints(2 * a, 2, [a](uint32_t i, unsigned d) {
            return (d == 0 ? i >> a : i & ((1u << a) - 1)) << (32 - a);
        });
        EXPECT_EQ(tValue(grid.set()), a);
    }
    const RawPoints cube =
        makePoints(6, 3, [](uint32_t i, unsigned d) { return ((i >> (2 * d)) & 3u) << 30; });
    EXPECT_EQ(tValue(cube.set()), 4u);
    EXPECT_FALSE(checkNet(cube.set(), 0, NetBase::four).holds());
    EXPECT_TRUE(checkNet(sobolPoints(6).set(), 0, NetBase::four).holds());
}

// The same coordinate twice, and Halton's second coordinate (base 3), are stratified otherwise.
TEST(Nets, OtherLowDiscrepancyPointsAreNoNetsInBaseTwo) {
    const RawPoints diagonal =
        makePoints(8, 2, [](uint32_t i, unsigned) { return sobolSample(sobolMatrix(0), i); });
    EXPECT_TRUE(checkStrata(diagonal.set(), 0).holds());
    EXPECT_TRUE(checkStrata(diagonal.set(), 1).holds());
    EXPECT_EQ(tValue(diagonal.set()), 7u);

    const RawPoints ternary = makePoints(8, 1, [](uint32_t i, unsigned) {
        double value = 0;
        for (double place = 1.0 / 3; i > 0; i /= 3, place /= 3) value += place * (i % 3);
        return static_cast<uint32_t>(value * 0x1p32);
    });
    EXPECT_GT(tValue(ternary.set()), 0u);
}

TEST(Nets, RandomPointsFail) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const PointSet points = randomPoints(8, 3, seed).set();
        for (unsigned d = 0; d < 3; ++d) EXPECT_FALSE(checkStrata(points, d).holds());
        EXPECT_FALSE(checkNet(points.projection({0, 1}), 0).holds());
        EXPECT_FALSE(checkNet(points, 1).holds());
        EXPECT_FALSE(checkNet(points, 0, NetBase::four).holds());
        EXPECT_GT(tValue(points), 2u);
    }
}

TEST(Nets, DuplicatedPointFails) {
    for (std::size_t i = 1; i < 64; ++i) {
        RawPoints points = sobolPoints(6);
        for (unsigned d = 0; d < 3; ++d) points.at(i, d) = points.at(0, d);
        EXPECT_FALSE(checkNet(points.set().projection({0, 1}), 0).holds());
        EXPECT_FALSE(checkStrata(points.set(), 2).holds());
        EXPECT_FALSE(checkNet(points.set(), 0, NetBase::four).holds());
    }
}

// Each of the digits that decide is looked at; those beyond are free.
TEST(Nets, AnyFlippedDigitThatMattersFails) {
    constexpr unsigned kM = 8;
    const RawPoints points = sobolPoints(kM);
    for (unsigned d = 0; d < 2; ++d) {
        for (unsigned digit = 0; digit < 32; ++digit) {
            RawPoints flipped = points;
            flipped.at(37, d) ^= 0x80000000u >> digit;
            EXPECT_EQ(checkNet(flipped.set().projection({0, 1}), 0).holds(), digit >= kM);
            EXPECT_EQ(checkStrata(flipped.set(), d).holds(), digit >= kM);
            EXPECT_EQ(checkNet(flipped.set(), 1).holds(), digit >= kM - 1);
        }
    }
}

// A digital shift and nested uniform scrambling keep t (Owen 1995); a rotation modulo 1 does not.
TEST(Nets, ScramblingKeepsTAndRotationDoesNot) {
    RawPoints shifted = sobolPoints(10), scrambled = shifted, rotated = shifted;
    for (std::size_t i = 0; i < shifted.count(); ++i) {
        for (unsigned d = 0; d < 3; ++d) {
            shifted.at(i, d) ^= 0x9e3779b9u * (d + 1);
            scrambled.at(i, d) = owenScramble(scrambled.at(i, d), d);
            rotated.at(i, d) += 0x9e3779b9u * (d + 1);
        }
    }
    EXPECT_EQ(tValue(shifted.set()), 1u);
    EXPECT_EQ(tValue(scrambled.set()), 1u);
    EXPECT_GT(tValue(rotated.set()), 1u);
}

TEST(Nets, FirstViolationNamesPointsIntervalAndCount) {
    RawPoints points = sobolPoints(3, 2);
    points.at(6, 0) = points.at(7, 0);
    const NetReport report = checkSequence(points.set(), 0);
    EXPECT_EQ(report.firstViolation, "points [6, 8): [0/2, 1/2) x [0, 1) holds 0, not 1");
    EXPECT_GT(report.violations, 1u);
}

TEST(Nets, ReportsAddUp) {
    NetReport sum;
    sum += {10, 0, ""};
    EXPECT_TRUE(sum.holds());
    sum += {20, 2, "first"};
    sum += {30, 3, "second"};
    EXPECT_EQ(sum.intervals, 60u);
    EXPECT_EQ(sum.violations, 5u);
    EXPECT_EQ(sum.firstViolation, "first");
}

TEST(PointSet, FloatsAndIntegersGiveTheSamePoints) {
    const RawPoints raw = sobolPoints(10, 2); // 10 digits fit in a float
    std::vector<float> floats;
    std::vector<double> doubles;
    for (const uint32_t value : raw.values) {
        floats.push_back(static_cast<float>(value) * 0x1p-32f);
        doubles.push_back(value * 0x1p-32);
    }
    const PointSet expected = raw.set();
    for (const PointSet& points : {PointSet::fromFloats(floats.data(), raw.count(), 2),
                                   PointSet::fromFloats(doubles.data(), raw.count(), 2)}) {
        for (unsigned d = 0; d < 2; ++d) {
            for (std::size_t i = 0; i < raw.count(); ++i) {
                ASSERT_EQ(points.coordinate(d)[i], expected.coordinate(d)[i]);
            }
        }
    }
}

// Guards against rounding to nearest, which moves values up across a boundary.
TEST(PointSet, ValuesJustBelowABoundaryStayBelow) {
    const float floats[] = {std::nextafter(1.0f, 0.0f), std::nextafter(0.5f, 0.0f), -0.0f,
                            std::numeric_limits<float>::denorm_min()};
    const PointSet fromFloats = PointSet::fromFloats(floats, 4, 1);
    EXPECT_EQ(fromFloats.coordinate(0)[0], 0xffffff00u);
    EXPECT_EQ(fromFloats.coordinate(0)[1], 0x7fffff80u);
    EXPECT_EQ(fromFloats.coordinate(0)[2], 0u);
    EXPECT_EQ(fromFloats.coordinate(0)[3], 0u);
    const double doubles[] = {std::nextafter(1.0, 0.0), std::nextafter(0.5, 0.0)};
    const PointSet fromDoubles = PointSet::fromFloats(doubles, 2, 1);
    EXPECT_EQ(fromDoubles.coordinate(0)[0], 0xffffffffu);
    EXPECT_EQ(fromDoubles.coordinate(0)[1], 0x7fffffffu);
}

TEST(PointSet, BadValuesAreNamed) {
    EXPECT_EQ(errorOf([] { fromFloat(1.0f); }),
              "coordinate 1 of point 1 is 1; accepted are values in [0, 1)");
    EXPECT_EQ(errorOf([] { fromFloat(-1e-30f); }),
              "coordinate 1 of point 1 is -1e-30; accepted are values in [0, 1)");
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 2.0f}) {
        EXPECT_NE(errorOf([=] { fromFloat(bad); }).find("coordinate 1 of point 1"),
                  std::string::npos);
    }
}

TEST(PointSet, BadCountsAndDimensionsAreRefused) {
    const std::vector<uint32_t> values(64);
    const auto make = [&](std::size_t count, unsigned dims) {
        return errorOf([&] { PointSet::fromIntegers(values.data(), count, dims); });
    };
    EXPECT_EQ(make(0, 2), "the number of points is 0; accepted are powers of two from 1 to 2^31");
    EXPECT_EQ(make(12, 2), "the number of points is 12; accepted are powers of two from 1 to 2^31");
    EXPECT_EQ(make(8, 0), "the number of dimensions is 0; accepted are 1 to 6");
    EXPECT_EQ(make(8, 7), "the number of dimensions is 7; accepted are 1 to 6");
    EXPECT_EQ(make(8, 6), "no error");
}

TEST(PointSet, ProjectionsAndBlocks) {
    const RawPoints raw = randomPoints(4, 3, 1);
    const PointSet points = raw.set();
    const PointSet swapped = points.projection({2, 0});
    const PointSet block = points.block(8, 4);
    EXPECT_EQ(swapped.dims(), 2u);
    EXPECT_EQ(block.count(), 4u);
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(swapped.coordinate(0)[i], raw.at(i, 2));
        EXPECT_EQ(swapped.coordinate(1)[i], raw.at(i, 0));
    }
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(block.coordinate(1)[i], raw.at(8 + i, 1));

    EXPECT_EQ(errorOf([&] {
                  points.projection({0, 3});
              }),
              "coordinate 3 does not exist; the points have 3");
    EXPECT_EQ(errorOf([&] { points.projection({}); }),
              "the number of dimensions is 0; accepted are 1 to 6");
    EXPECT_EQ(errorOf([&] { points.block(14, 4); }),
              "points 14 to 17 are asked for; the set has 16");
    EXPECT_EQ(
        errorOf([&] { points.block(std::numeric_limits<std::size_t>::max(), 32); }).find("points "),
        0u);
}

TEST(Nets, ImpossibleParametersAreRefused) {
    const PointSet points = randomPoints(3, 2, 1).set();
    EXPECT_EQ(errorOf([&] { checkNet(points, 0, NetBase::four); }),
              "8 points are no net in base 4; accepted are powers of four");
    EXPECT_EQ(errorOf([&] { checkNet(points, 4); }), "t is 4; accepted for 8 points are 0 to 3");
    EXPECT_EQ(errorOf([&] { checkStrata(points, 2); }),
              "coordinate 2 does not exist; the points have 2");
}

} // namespace
} // namespace wellstrat::test
