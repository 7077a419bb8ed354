// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/independence.h"

#include "RixRNG.h"
#include "analysis/measured_points.h"
#include "src/analysis/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace wellstrat {
namespace {

using test::makeUnitPoints;
using test::randomUnitPoints;

constexpr std::size_t kCount = 4096;

/// Streams of random numbers, named by their place.
std::vector<SampleStream> randomStreams(unsigned streams, unsigned dims, uint32_t seed) {
    std::vector<SampleStream> result;
    for (unsigned s = 0; s < streams; ++s) {
        result.push_back({std::to_string(s), randomUnitPoints(kCount, dims, hashPair(seed, s))});
    }
    return result;
}

/// The samples of contexts of the tables.
std::vector<SampleStream> tableStreams(const std::vector<SampleCtx>& contexts) {
    std::vector<SampleStream> result;
    for (const SampleCtx& first : contexts) {
        std::vector<double> values;
        SampleCtx context = first;
        RixRNG rng(&context, 1);
        for (std::size_t i = 0; i < kCount; ++i) {
            const Float3 xyz = rng.GenerateSample3D(0);
            values.insert(values.end(), {xyz.x, xyz.y, xyz.z});
        }
        result.push_back({"", {values.data(), kCount, 3}});
    }
    return result;
}

/// One degree: the normal distribution's. Two: the exponential one's. Any even number 2n: the
/// probability of less than n events of Poisson's.
TEST(ChiSquareTails, ClosedForms) {
    for (const double x : {1e-3, 0.1, 1.0, 2.9, 3.1, 10.0, 40.0, 200.0}) {
        EXPECT_NEAR(chiSquareTails(x, 1).above / std::erfc(std::sqrt(x / 2)), 1, 1e-12) << x;
        EXPECT_NEAR(chiSquareTails(x, 2).above / std::exp(-x / 2), 1, 1e-12) << x;
        double poisson = 0;
        for (int k = 0; k < 30; ++k) {
            poisson += std::exp(k * std::log(x / 2) - x / 2 - std::lgamma(k + 1));
        }
        const Tails tails = chiSquareTails(x, 60);
        EXPECT_NEAR(tails.above / poisson, 1, 1e-11) << x;
        EXPECT_NEAR(tails.above + tails.below, 1, 1e-15);
    }
    EXPECT_EQ(chiSquareTails(0, 5).below, 0);
    EXPECT_NEAR(chiSquareTails(0.02, 4).below, 1 - 1.01 * std::exp(-0.01), 1e-15);
}

/// Four points on a 2 x 2 grid, by hand: x = 0, .5, 0, .5 and y = 0, 0, .5, .5 are independent, and
/// x against itself is two pairs that a coin has swapped alike; so the correlation has the variance
/// of two coins.
TEST(Independence, OfFourPoints) {
    const auto stream = [](unsigned shift) {
        return makeUnitPoints(
            4, 1, [=](std::size_t i, unsigned) { return ((i >> shift) & 1) != 0 ? 0.5 : 0.0; });
    };
    const auto test = [&](unsigned a, unsigned b) {
        return testIndependence({{"a", stream(a)}, {"b", stream(b)}}, 2, 1).worst.front();
    };
    EXPECT_NEAR(test(0, 1).correlation, 0, 1e-15);
    EXPECT_EQ(test(0, 1).correlationProbability, 1);
    EXPECT_NEAR(test(0, 1).chiSquare, 0, 1e-15);
    EXPECT_NEAR(test(0, 0).correlation, 1, 1e-15);
    EXPECT_NEAR(test(0, 0).chiSquare, 2, 1e-15);
    EXPECT_NEAR(test(0, 0).correlationDeviation, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(test(0, 0).correlationProbability, std::erfc(1), 1e-15);
    EXPECT_NEAR(test(0, 0).chiSquareProbability, 0.5, 1e-15);
}

/// A table of 2 x 2 cells of two points each, of which one coordinate is in no nested order:
/// (0,0) (0,0) (1,1) (1,1) and so on has Pearson's chi-square 8 of 8 points, with one degree.
TEST(Independence, OfAContingencyTable) {
    const UnitPoints halves =
        makeUnitPoints(8, 1, [](std::size_t i, unsigned) { return (i & 2) != 0 ? 0.5 : 0.0; });
    const CoordinatePair pair =
        testIndependence({{"a", halves}, {"b", halves}}, 2, 1).worst.front();
    EXPECT_NEAR(pair.chiSquare, 8, 1e-14);
    EXPECT_NEAR(pair.chiSquareProbability, 2 * std::erfc(std::sqrt(4.0)), 1e-15);
}

/// 20 runs of 252 pairs. The probability of a run is uniform, so that one in 20,000 test runs fails
/// at the limit of 1 / 400,000 for no reason; the means are within six standard errors.
TEST(Independence, OfRandomStreams) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const IndependenceReport report = testIndependence(randomStreams(8, 3, seed), 16, 5);
        EXPECT_EQ(report.pairs, 252u);
        ASSERT_EQ(report.worst.size(), 5u);
        EXPECT_GT(report.probability(), 1.0 / 400000);
        EXPECT_NEAR(report.correlationSpread, 1, 6 / std::sqrt(2 * 252.0));
        EXPECT_NEAR(report.meanChiSquare, 1, 6 * std::sqrt(2.0 / 225 / 252));
        for (std::size_t k = 1; k < 5; ++k) {
            EXPECT_LE(report.worst[k - 1].probability(), report.worst[k].probability());
        }
    }
}

TEST(Independence, NamesTheCorrelatedPair) {
    std::vector<SampleStream> streams = randomStreams(6, 2, 1);
    const UnitPoints& source = streams[1].points;
    const UnitPoints& noise = streams[4].points;
    const UnitPoints mixed = makeUnitPoints(kCount, 2, [&](std::size_t i, unsigned d) {
        return d == 0 ? noise.coordinate(0)[i]
                      : 0.8 * noise.coordinate(1)[i] + 0.2 * source.coordinate(0)[i];
    });
    streams[4].points = mixed;
    const IndependenceReport report = testIndependence(streams, 16, 3);
    EXPECT_LT(report.probability(), 1e-10);
    EXPECT_EQ(report.worst[0].first, 1u);
    EXPECT_EQ(report.worst[0].firstDim, 0u);
    EXPECT_EQ(report.worst[0].second, 4u);
    EXPECT_EQ(report.worst[0].secondDim, 1u);
    EXPECT_GT(report.worst[1].probability() * 2 * 60, 1e-6);
}

/// y = |2 x - 1|: no correlation, but dependence.
TEST(Independence, SeesDependenceWithoutCorrelation) {
    const UnitPoints x = randomUnitPoints(kCount, 1, 1);
    const UnitPoints y = makeUnitPoints(kCount, 1, [&](std::size_t i, unsigned) {
        return std::min(std::fabs(2 * x.coordinate(0)[i] - 1), std::nextafter(1.0, 0.0));
    });
    const CoordinatePair pair = testIndependence({{"x", x}, {"y", y}}, 16, 1).worst.front();
    EXPECT_LT(std::fabs(pair.correlation), 0.1);
    EXPECT_LT(pair.chiSquareProbability, 1e-100);
}

/// Domains that visit one net in lockstep: each pair of coordinates fills the grid too evenly.
TEST(Independence, SeesLockstep) {
    const UnitPoints points = test::unitPoints(test::owenPoints(12, 2, 1));
    const CoordinatePair pair =
        testIndependence({{"a", points.projection({0})}, {"b", points.projection({1})}}, 16, 1)
            .worst.front();
    EXPECT_LT(pair.chiSquare, 0.01);
    EXPECT_LT(pair.chiSquareProbability, 1e-70);
}

/// A missing scramble: two patterns that are the same.
TEST(Independence, SeesAMissingScramble) {
    const IndependenceReport report = testIndependence(tableStreams({{7, 0}, {7, 0}}), 16, 9);
    EXPECT_NEAR(report.worst[0].correlation, 1, 1e-12);
    EXPECT_EQ(report.worst[0].firstDim, report.worst[0].secondDim);
}

/// Three copies of a net without any scramble: x against y, which fills the grid too evenly, must
/// not hide that each coordinate is its own copy; with and without underflow of probabilities.
TEST(Independence, NamesCopiesBeforeLockstep) {
    for (const unsigned m : {7u, 10u, 12u, 16u}) {
        const UnitPoints net = test::unitPoints(test::owenPoints(m, 2, 1));
        const IndependenceReport report =
            testIndependence({{"a", net}, {"b", net}, {"c", net}}, usualGridSide(net.count()), 12);
        for (std::size_t k = 0; k < 6; ++k) {
            EXPECT_NEAR(report.worst[k].correlation, 1, 1e-12);
            EXPECT_EQ(report.worst[k].firstDim, report.worst[k].secondDim);
        }
        EXPECT_NEAR(report.worst[6].chiSquare, 0, 1e-12);
        EXPECT_NE(report.worst[6].firstDim, report.worst[6].secondDim);
    }
}

/// 4 x 4 cells of two points each. Of nested orders, 8 coins have 4 heads, and 4 times 4 coins have
/// 2; of other orders, 8!^8 / (32! 2!^16) of all lead to them: the points come by rows.
TEST(Independence, EvenCountsAreNotImpossible) {
    const UnitPoints points = test::unitPoints(test::owenPoints(5, 2, 1));
    const CoordinatePair nested =
        testIndependence({{"a", points.projection({0})}, {"b", points.projection({1})}}, 4, 1)
            .worst.front();
    EXPECT_EQ(nested.chiSquare, 0);
    EXPECT_NEAR(nested.chiSquareProbability, 2 * 70 * std::pow(6, 4) / std::pow(2, 24), 1e-13);
    const UnitPoints rows = makeUnitPoints(
        32, 2, [](std::size_t i, unsigned d) { return double(d == 0 ? i / 8 : i % 4) / 4; });
    const CoordinatePair table =
        testIndependence({{"a", rows.projection({0})}, {"b", rows.projection({1})}}, 4, 1)
            .worst.front();
    EXPECT_EQ(table.chiSquare, 0);
    EXPECT_NEAR(table.chiSquareProbability, 2 * 0.00040505361248516133, 1e-13);
}

/// The same net again and again, its order scrambled at all levels by exact nested shuffles, its
/// coordinates by nested scrambling.
UnitPoints exactlyShuffled(unsigned m, unsigned dims, uint32_t seed) {
    return test::unitPoints(test::makePoints(m, dims, [=](uint32_t i, unsigned d) {
        const uint32_t shuffled = owenScramble(i << (32 - m), hashPair(1, seed), m) >> (32 - m);
        return owenScramble(sobolSample(sobolMatrix(d), shuffled), hashPair(hashPair(2, seed), d));
    }));
}

/// How far probabilities are from evenly spread (Kolmogorov 1933), times the root of how many there
/// are: above 2.7 once in a million.
double unevenness(std::vector<double> probabilities) {
    std::sort(probabilities.begin(), probabilities.end());
    const auto count = static_cast<double>(probabilities.size());
    double furthest = 0;
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
        furthest = std::max(furthest, std::fabs(probabilities[i] - (double(i) + 0.5) / count));
    }
    return furthest * std::sqrt(count);
}

/// The probabilities of pairs of single coordinates, each pair of streams of its own.
template <class MakeStream>
void expectEvenProbabilities(unsigned pairs, const MakeStream& stream) {
    std::vector<double> ofCorrelations, ofCounts;
    for (uint32_t k = 0; k < pairs; ++k) {
        const UnitPoints first = stream(2 * k), second = stream(2 * k + 1);
        const CoordinatePair pair =
            testIndependence({{"a", first}, {"b", second}}, usualGridSide(first.count()), 1)
                .worst.front();
        ofCorrelations.push_back(pair.correlationProbability);
        ofCounts.push_back(pair.chiSquareProbability);
    }
    EXPECT_LT(unevenness(ofCorrelations), 2.7);
    EXPECT_LT(unevenness(ofCounts), 2.7);
}

/// The probabilities of independent streams are what they say: evenly spread over [0, 1). A false
/// alarm in a million each. As probabilities of random orders those of nets are uneven by more than
/// 4 and 12.
TEST(Independence, ProbabilitiesOfNetsAreEven) {
    expectEvenProbabilities(
        2000, [](uint32_t k) { return exactlyShuffled(9 + k / 2 % 2, 2, k).projection({k % 2}); });
}

/// The first points of three blocks of 256.
TEST(Independence, ProbabilitiesOfPartsOfNetsAreEven) {
    expectEvenProbabilities(2000, [](uint32_t k) {
        const UnitPoints net = exactlyShuffled(10, 1, k);
        return makeUnitPoints(768, 1,
                              [&](std::size_t i, unsigned) { return net.coordinate(0)[i]; });
    });
}

TEST(Independence, ProbabilitiesOfRandomStreamsAreEven) {
    expectEvenProbabilities(2000, [](uint32_t k) { return randomUnitPoints(1024, 1, k); });
}

/// A net against random numbers.
TEST(Independence, ProbabilitiesOfMixedStreamsAreEven) {
    expectEvenProbabilities(2000, [](uint32_t k) {
        return k % 2 == 0 ? exactlyShuffled(10, 1, k) : randomUnitPoints(1024, 1, k);
    });
}

/// Domains of the library are as independent as exact nested shuffles are: 50 pixels of 16 domains,
/// in pairs. A false alarm in a million each.
TEST(Independence, ProbabilitiesOfDomainsAreEven) {
    expectEvenProbabilities(400, [](uint32_t k) {
        const SampleCtx pixel{hashPair(3, k / 16), 0};
        return tableStreams({pixel.NewDomain(static_cast<Scramble>(k % 16))})[0].points.projection(
            {k / 2 % 3});
    });
}

/// All pairs of coordinates of 32 domains: none is unlikely, and the means are within six standard
/// errors, as if the 4464 pairs were independent of each other.
TEST(Independence, OfDomains) {
    constexpr unsigned domains = 32;
    std::vector<SampleCtx> contexts;
    for (unsigned s = 0; s < domains; ++s) {
        contexts.push_back(SampleCtx{1, 0}.NewDomain(static_cast<Scramble>(s)));
    }
    const IndependenceReport report = testIndependence(tableStreams(contexts), 16, 1);
    EXPECT_NEAR(report.correlationSpread, 1, 6 / std::sqrt(2 * 4464.0));
    EXPECT_NEAR(report.meanChiSquare, 1, 6 * std::sqrt(2.0 / 85 / 4464));
    EXPECT_GT(report.probability(), 1e-6);
}

TEST(Independence, ConstantCoordinatesSayNothing) {
    const UnitPoints constant = makeUnitPoints(64, 1, [](std::size_t, unsigned) { return 0.25; });
    const CoordinatePair pair =
        testIndependence({{"a", constant}, {"b", randomUnitPoints(64, 1, 1)}}, 2, 1).worst.front();
    EXPECT_EQ(pair.correlation, 0);
    EXPECT_EQ(pair.chiSquare, 1);
    EXPECT_EQ(pair.probability(), 1);
}

TEST(Independence, RejectsWhatItCannotDo) {
    const auto points = [](std::size_t count) { return randomUnitPoints(count, 1, 1); };
    EXPECT_THROW(testIndependence({{"a", points(8)}}, 2, 1), PointError);
    EXPECT_THROW(testIndependence({{"a", points(8)}, {"b", points(9)}}, 2, 1), PointError);
    EXPECT_THROW(testIndependence({{"a", points(2)}, {"b", points(2)}}, 2, 1), PointError);
    EXPECT_THROW(testIndependence({{"a", points(8)}, {"b", points(8)}}, 1, 1), PointError);
    EXPECT_THROW(testIndependence({{"a", points(8)}, {"b", points(8)}}, 1025, 1), PointError);
}

TEST(Independence, UsualGridLeavesEightPointsACell) {
    EXPECT_EQ(usualGridSide(3), 2u);
    EXPECT_EQ(usualGridSide(127), 2u);
    EXPECT_EQ(usualGridSide(128), 4u);
    EXPECT_EQ(usualGridSide(4096), 16u);
    EXPECT_EQ(usualGridSide(1 << 20), 32u);
}

} // namespace
} // namespace wellstrat
