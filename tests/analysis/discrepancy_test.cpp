// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/discrepancy.h"

#include "analysis/measured_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wellstrat {
namespace {

using test::hammersleyPoints;
using test::makeUnitPoints;
using test::owenPoints;
using test::randomUnitPoints;
using test::sobolPoints;
using test::unitPoints;

constexpr std::array kKinds{L2Kind::star, L2Kind::centered, L2Kind::wrapAround, L2Kind::mixture,
                            L2Kind::modified};

template <class Real>
Real square(Real x) {
    return x * x;
}

/// The formulas as published, term by term.
long double published(const UnitPoints& points, L2Kind kind) {
    const auto s = static_cast<long double>(points.dims());
    const auto n = static_cast<long double>(points.count());
    const auto sum = [&](const auto& factor) {
        long double total = 0;
        for (std::size_t i = 0; i < points.count(); ++i) {
            long double product = 1;
            for (unsigned d = 0; d < points.dims(); ++d) product *= factor(points.coordinate(d)[i]);
            total += product;
        }
        return total;
    };
    const auto doubleSum = [&](const auto& factor) {
        long double total = 0;
        for (std::size_t i = 0; i < points.count(); ++i) {
            for (std::size_t j = 0; j < points.count(); ++j) {
                long double product = 1;
                for (unsigned d = 0; d < points.dims(); ++d) {
                    product *= factor(points.coordinate(d)[i], points.coordinate(d)[j]);
                }
                total += product;
            }
        }
        return total;
    };
    const auto off = [](long double x) { return std::fabs(x - 0.5); };
    const auto gap = [](long double x, long double y) { return std::fabs(x - y); };
    switch (kind) {
    case L2Kind::star: // Warnock 1972
        return std::pow(3.0L, -s) -
               std::pow(2.0L, 1 - s) / n * sum([](long double x) { return 1 - square(x); }) +
               doubleSum([](long double x, long double y) { return 1 - std::max(x, y); }) /
                   square(n);
    case L2Kind::centered: // Hickernell 1998
        return std::pow(13.0L / 12, s) -
               2 / n * sum([&](long double x) { return 1 + 0.5 * off(x) - 0.5 * square(off(x)); }) +
               doubleSum([&](long double x, long double y) {
                   return 1 + 0.5 * off(x) + 0.5 * off(y) - 0.5 * gap(x, y);
               }) / square(n);
    case L2Kind::wrapAround: // Hickernell 1998
        return -std::pow(4.0L / 3, s) + doubleSum([&](long double x, long double y) {
                                            return 1.5 - gap(x, y) * (1 - gap(x, y));
                                        }) / square(n);
    case L2Kind::mixture: // Zhou, Fang, Ning 2013
        return std::pow(19.0L / 12, s) -
               2 / n * sum([&](long double x) {
                   return 5.0L / 3 - 0.25 * off(x) - 0.25 * square(off(x));
               }) +
               doubleSum([&](long double x, long double y) {
                   return 15.0L / 8 - 0.25 * off(x) - 0.25 * off(y) - 0.75 * gap(x, y) +
                          0.5 * square(gap(x, y));
               }) / square(n);
    case L2Kind::modified: // Fang, Lin, Winker, Zhang 2000, "Uniform design"
        return std::pow(4.0L / 3, s) -
               std::pow(2.0L, 1 - s) / n * sum([](long double x) { return 3 - square(x); }) +
               doubleSum([](long double x, long double y) { return 2 - std::max(x, y); }) /
                   square(n);
    }
    return 0;
}

/// Points with many equal coordinates, 0 among them.
UnitPoints tiedPoints(std::size_t count, unsigned dims, uint32_t seed) {
    return makeUnitPoints(count, dims, [=](std::size_t i, unsigned d) {
        return (hashPair(seed, static_cast<uint32_t>(i) * dims + d) >> 29) / 8.0;
    });
}

TEST(L2Discrepancy, IsThePublishedFormula) {
    for (const unsigned dims : {1u, 2u, 3u, 4u, 7u}) {
        for (const std::size_t count : {1u, 2u, 7u, 255u, 256u, 257u, 700u}) {
            for (const UnitPoints& points :
                 {randomUnitPoints(count, dims, dims), tiedPoints(count, dims, dims)}) {
                const std::vector<double> found =
                    l2Discrepancies(points, {kKinds.begin(), kKinds.end()});
                for (std::size_t k = 0; k < kKinds.size(); ++k) {
                    const long double error =
                        square<long double>(found[k]) - published(points, kKinds[k]);
                    EXPECT_NEAR(static_cast<double>(error), 0, 1e-14)
                        << dims << " dimensions, " << count << " points, kind " << k;
                    EXPECT_EQ(found[k], l2Discrepancy(points, kKinds[k]));
                }
            }
        }
    }
}

/// Fang, Li, Sudjianto 2006, "Design and modeling for computer experiments", chapter 3: two
/// designs of six points, squared centered discrepancies 0.0081 and 0.0105.
TEST(L2Discrepancy, CenteredOfPublishedDesigns) {
    constexpr std::array<int, 6> first{3, 6, 2, 5, 1, 4};
    constexpr std::array<int, 6> second{5, 4, 3, 2, 1, 6};
    const auto design = [](const std::array<int, 6>& y) {
        return makeUnitPoints(6, 2, [&](std::size_t i, unsigned d) {
            return ((d == 0 ? static_cast<double>(i) + 1 : y[i]) - 0.5) / 6;
        });
    };
    EXPECT_NEAR(square(l2Discrepancy(design(first), L2Kind::centered)), 0.0081, 5e-5);
    EXPECT_NEAR(square(l2Discrepancy(design(second), L2Kind::centered)), 0.0105, 5e-5);
}

/// Halton, Zaremba 1969, "The extreme and L2 discrepancies of some plane sets", Monatshefte fuer
/// Mathematik 73, 316-328: the Hammersley points in base 2.
TEST(L2Discrepancy, StarOfHammersleyPoints) {
    for (unsigned m = 1; m <= 18; ++m) {
        const double n = std::ldexp(1.0, static_cast<int>(m));
        const double expected =
            m * m / 64.0 + 29 * m / 192.0 + 3.0 / 8 - m / (16 * n) + 1 / (4 * n) - 1 / (72 * n * n);
        const double found = l2Discrepancy(unitPoints(hammersleyPoints(m, 2)), L2Kind::star);
        EXPECT_NEAR(square(n * found) / expected, 1, 1e-6) << m;
    }
}

/// The largest difference over all boxes, by trying them.
double triedStar(const UnitPoints& points) {
    const unsigned dims = points.dims();
    std::vector<std::vector<double>> ends(dims);
    std::size_t boxes = 1;
    for (unsigned d = 0; d < dims; ++d) {
        ends[d].assign(points.coordinate(d), points.coordinate(d) + points.count());
        ends[d].push_back(1);
        boxes *= ends[d].size();
    }
    double largest = 0;
    for (std::size_t box = 0; box < boxes; ++box) {
        std::vector<double> end(dims);
        double volume = 1;
        for (std::size_t d = 0, rest = box; d < dims; ++d) {
            end[d] = ends[d][rest % ends[d].size()];
            rest /= ends[d].size();
            volume *= end[d];
        }
        double open = 0, closed = 0;
        for (std::size_t i = 0; i < points.count(); ++i) {
            bool inside = true, insideOrOn = true;
            for (unsigned d = 0; d < dims; ++d) {
                inside = inside && points.coordinate(d)[i] < end[d];
                insideOrOn = insideOrOn && points.coordinate(d)[i] <= end[d];
            }
            open += inside;
            closed += insideOrOn;
        }
        const auto count = static_cast<double>(points.count());
        largest = std::max({largest, volume - open / count, closed / count - volume});
    }
    return largest;
}

TEST(StarDiscrepancy, IsTheLargestOfAllBoxes) {
    for (unsigned dims = 1; dims <= 3; ++dims) {
        for (const std::size_t count : {1u, 2u, 3u, 8u, 13u, 24u}) {
            for (uint32_t seed = 0; seed < 10; ++seed) {
                for (const UnitPoints& points :
                     {randomUnitPoints(count, dims, seed), tiedPoints(count, dims, seed)}) {
                    const StarBounds star = starDiscrepancy(points, 100000);
                    EXPECT_TRUE(star.exact());
                    EXPECT_NEAR(star.lower, triedStar(points), 1e-14)
                        << dims << " dimensions, " << count << " points, seed " << seed;
                }
            }
        }
    }
}

/// Niederreiter 1992, theorem 2.6: the points (2 i + 1) / (2 N) reach the minimum, 1 / (2 N).
TEST(StarDiscrepancy, OfMidpoints) {
    const UnitPoints points = makeUnitPoints(
        100, 1, [](std::size_t i, unsigned) { return (static_cast<double>(i) + 0.5) / 100; });
    EXPECT_NEAR(starDiscrepancy(points).lower, 0.005, 1e-15);
}

/// Halton, Zaremba 1969; from two digits on.
TEST(StarDiscrepancy, OfHammersleyPoints) {
    for (unsigned m = 2; m <= 16; ++m) {
        const double n = std::ldexp(1.0, static_cast<int>(m));
        const double expected = m / 3.0 + 13.0 / 9 - (m % 2 == 0 ? 1 : -1) * 4 / (9 * n);
        const StarBounds star = starDiscrepancy(unitPoints(hammersleyPoints(m, 2)));
        EXPECT_TRUE(star.exact());
        EXPECT_NEAR(n * star.lower, expected, 1e-9) << m;
    }
}

TEST(StarDiscrepancy, BoundsHoldAndNarrow) {
    const UnitPoints points = unitPoints(owenPoints(8, 3, 1));
    const StarBounds exact = starDiscrepancy(points, 1000000);
    ASSERT_TRUE(exact.exact());
    double width = 1;
    for (const std::size_t sweeps : {3u, 20u, 100u, 400u}) {
        const StarBounds bounds = starDiscrepancy(points, sweeps);
        EXPECT_LE(bounds.lower, exact.lower);
        EXPECT_GE(bounds.upper, exact.lower);
        EXPECT_LE(bounds.upper - bounds.lower, width);
        width = bounds.upper - bounds.lower;
    }
    EXPECT_LT(width, 0.02);
}

TEST(StarDiscrepancy, RejectsMoreThanThreeDimensions) {
    EXPECT_THROW(starDiscrepancy(randomUnitPoints(4, 4, 1)), PointError);
}

/// A flipped bit of a generator matrix.
TEST(Discrepancy, SeesAWrongMatrixColumn) {
    test::RawPoints wrong = sobolPoints(10, 2);
    for (std::size_t i = 0; i < wrong.count(); ++i)
        wrong.at(i, 1) ^= static_cast<uint32_t>(i & 512u) << 21;
    const UnitPoints right = unitPoints(sobolPoints(10, 2));
    EXPECT_GT(starDiscrepancy(unitPoints(wrong)).lower, 1.5 * starDiscrepancy(right).lower);
    for (const L2Kind kind : kKinds) {
        EXPECT_GT(l2Discrepancy(unitPoints(wrong), kind), l2Discrepancy(right, kind))
            << static_cast<int>(kind);
    }
}

} // namespace
} // namespace wellstrat
