// SPDX-License-Identifier: Apache-2.0
//
// RixRNG: constructors, the twelve draw and generate functions and their first-n forms, and what
// the three kinds of new domains promise.

#include "RixRNG.h"
#include "wellstrat/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace {

using SampleCtx = RixRNG::SampleCtx;
using Scramble = RixRNG::Scramble;

constexpr Scramble kBxdf = static_cast<Scramble>(0x2d96c92bu);
constexpr Scramble kLight = static_cast<Scramble>(0x3917fe2eu);
constexpr unsigned kPoints = 5;

void expectEqual(const SampleCtx& a, const SampleCtx& b) {
    EXPECT_EQ(a.patternid, b.patternid);
    EXPECT_EQ(a.sampleid, b.sampleid);
}

/// Whether n values have exactly one in each of n strata of [0, 1).
bool fillsStrata(const std::vector<float>& values) {
    std::set<unsigned> strata;
    const auto n = static_cast<float>(values.size());
    for (const float v : values) strata.insert(static_cast<unsigned>(v * n));
    return strata.size() == values.size();
}

/// The correlation coefficient of two uniform variables on [0, 1), of known mean and variance.
double correlation(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
    return 12 * sum / static_cast<double>(a.size());
}

/// What the correlation of n independent pairs exceeds with probability 2e-9: six sigma.
double correlationBound(std::size_t n) { return 6 / std::sqrt(static_cast<double>(n)); }

class RixRNGTest : public testing::Test {
protected:
    RixRNGTest() {
        for (unsigned i = 0; i < kPoints; ++i) {
            contexts[i] = wellstrat::cameraContext(static_cast<int>(i), 7, 1, 3 * i);
        }
    }

    void expectSampleids(unsigned advanced, unsigned by) const {
        for (unsigned i = 0; i < kPoints; ++i) {
            EXPECT_EQ(contexts[i].sampleid, 3 * i + (i < advanced ? by : 0)) << "point " << i;
        }
    }

    SampleCtx contexts[kPoints];
    SampleCtx children[kPoints] = {};
};

// ---- constructors

TEST_F(RixRNGTest, ViewsTheContextsItIsGiven) {
    const RixRNG rng(contexts, kPoints);
    EXPECT_EQ(rng.sampleCtxArray, contexts);
    EXPECT_EQ(rng.numPts, kPoints);
    EXPECT_EQ(rng.generator, nullptr);
    contexts[2] = {99, 5};
    EXPECT_EQ(rng.DrawSample1D(2), RixProgressiveSample1D(99, 5)) << "filled in afterwards";
}

TEST_F(RixRNGTest, OverAParentLeavesTheContextsAsTheyAre) {
    const RixRNG parent(contexts, kPoints);
    SampleCtx own[2] = {{1, 2}, {3, 4}};
    for (const RixRNG& rng : {RixRNG(parent, own, 2), RixRNG(&parent, own, 2)}) {
        EXPECT_EQ(rng.sampleCtxArray, own);
        EXPECT_EQ(rng.numPts, 2u);
        expectEqual(own[0], {1, 2});
        expectEqual(own[1], {3, 4});
    }
}

TEST_F(RixRNGTest, DerivingConstructorsFillInTheDomainsOfAllPointsInOrder) {
    const RixRNG parent(contexts, kPoints);
    const auto check = [&](const RixRNG& rng, auto expected) {
        EXPECT_EQ(rng.sampleCtxArray, children);
        EXPECT_EQ(rng.numPts, kPoints);
        for (unsigned i = 0; i < kPoints; ++i) expectEqual(children[i], expected(contexts[i]));
        std::fill_n(children, kPoints, SampleCtx{});
    };
    const auto plain = [](SampleCtx sc) { return sc.NewDomain(kBxdf); };
    const auto distrib = [](SampleCtx sc) { return sc.NewDomainDistrib(kBxdf, 2); };
    const auto split = [](SampleCtx sc) { return sc.NewDomainSplit(kBxdf, 4); };
    check(RixRNG(parent, kBxdf, children), plain);
    check(RixRNG(&parent, kBxdf, children), plain);
    check(RixRNG(parent, kBxdf, children, RixRNG::Distrib{2}), distrib);
    check(RixRNG(&parent, kBxdf, children, RixRNG::Distrib{2}), distrib);
    check(RixRNG(parent, kBxdf, children, RixRNG::Split{4}), split);
    check(RixRNG(&parent, kBxdf, children, RixRNG::Split{4}), split);
}

TEST_F(RixRNGTest, DerivingInPlaceEqualsDerivingElsewhere) {
    const RixRNG rng(contexts, kPoints);
    const auto check = [&](auto derive) {
        SampleCtx inPlace[kPoints];
        std::copy_n(contexts, kPoints, inPlace);
        derive(rng, children);
        derive(RixRNG(inPlace, kPoints), inPlace);
        for (unsigned i = 0; i < kPoints; ++i) expectEqual(inPlace[i], children[i]);
    };
    check([](const RixRNG& r, SampleCtx* out) { r.NewDomains(kBxdf, out); });
    check([](const RixRNG& r, SampleCtx* out) { r.NewDomainsDistrib(kBxdf, 1, out); });
    check([](const RixRNG& r, SampleCtx* out) { r.NewDomainsSplit(kBxdf, 3, out); });
    check([](const RixRNG& r, SampleCtx* out) { RixRNG(r, kBxdf, out); });
}

TEST_F(RixRNGTest, OnePointAndAllPointDomainsAgree) {
    const RixRNG rng(contexts, kPoints);
    for (unsigned i = 0; i < kPoints; ++i) {
        rng.NewDomains(kLight, children);
        expectEqual(rng.NewDomain(i, kLight), children[i]);
        rng.NewDomainsDistrib(kLight, 8, children);
        expectEqual(rng.NewDomainDistrib(i, kLight, 8), children[i]);
        rng.NewDomainsSplit(kLight, 16, children);
        expectEqual(rng.NewDomainSplit(i, kLight, 16), children[i]);
    }
    expectSampleids(0, 0);
}

// ---- the twelve functions and their first-n forms

TEST_F(RixRNGTest, DrawsDoNotChangeState) {
    const RixRNG rng(contexts, kPoints);
    float xi1[kPoints];
    RtFloat2 xi2[kPoints];
    RtFloat3 xi3[kPoints];
    rng.DrawSamples1D(xi1);
    rng.DrawSamples2D(xi2);
    rng.DrawSamples3D(xi3);
    for (unsigned i = 0; i < kPoints; ++i) {
        EXPECT_EQ(rng.DrawSample1D(i), xi1[i]);
        EXPECT_EQ(rng.DrawSample2D(i), xi2[i]);
        EXPECT_EQ(rng.DrawSample3D(i), xi3[i]);
    }
    expectSampleids(0, 0);
}

TEST_F(RixRNGTest, GeneratesStepThePointToItsNextSample) {
    RixRNG rng(contexts, kPoints);
    const unsigned pattern = contexts[3].patternid;
    EXPECT_EQ(rng.GenerateSample1D(3), RixProgressiveSample1D(pattern, 9));
    EXPECT_EQ(rng.GenerateSample2D(3), RixProgressiveSample2D(pattern, 10));
    EXPECT_EQ(rng.GenerateSample3D(3), RixProgressiveSample3D(pattern, 11));
    EXPECT_EQ(contexts[3].patternid, pattern);
    EXPECT_EQ(contexts[3].sampleid, 12u);
    EXPECT_EQ(contexts[2].sampleid, 6u);
    EXPECT_EQ(contexts[4].sampleid, 12u);
}

TEST_F(RixRNGTest, AllPointGeneratesStepAllPoints) {
    RixRNG rng(contexts, kPoints);
    float xi1[kPoints];
    RtFloat2 xi2[kPoints];
    RtFloat3 xi3[kPoints];
    rng.GenerateSamples1D(xi1);
    rng.GenerateSamples2D(xi2);
    rng.GenerateSamples3D(xi3);
    expectSampleids(kPoints, 3);
    for (unsigned i = 0; i < kPoints; ++i) {
        const unsigned pattern = contexts[i].patternid;
        EXPECT_EQ(xi1[i], RixProgressiveSample1D(pattern, 3 * i));
        EXPECT_EQ(xi2[i], RixProgressiveSample2D(pattern, 3 * i + 1));
        EXPECT_EQ(xi3[i], RixProgressiveSample3D(pattern, 3 * i + 2));
    }
}

TEST_F(RixRNGTest, FirstNFormsTouchTheFirstNPointsOnly) {
    RixRNG rng(contexts, kPoints);
    float xi1[kPoints] = {-1, -1, -1, -1, -1};
    RtFloat2 xi2[kPoints];
    RtFloat3 xi3[kPoints];
    std::fill_n(xi2, kPoints, RtFloat2(-1, -1));
    std::fill_n(xi3, kPoints, RtFloat3(-1));
    rng.DrawSamples1D(3, xi1);
    rng.DrawSamples2D(3, xi2);
    rng.DrawSamples3D(3, xi3);
    expectSampleids(0, 0);
    for (unsigned i = 0; i < kPoints; ++i) {
        EXPECT_EQ(xi1[i], i < 3 ? rng.DrawSample1D(i) : -1.0f);
        EXPECT_EQ(xi2[i], i < 3 ? rng.DrawSample2D(i) : RtFloat2(-1, -1));
        EXPECT_EQ(xi3[i], i < 3 ? rng.DrawSample3D(i) : RtFloat3(-1));
    }
    rng.GenerateSamples1D(2, xi1);
    rng.GenerateSamples2D(2, xi2);
    rng.GenerateSamples3D(2, xi3);
    expectSampleids(2, 3);
    EXPECT_EQ(xi3[1], RixProgressiveSample3D(contexts[1].patternid, 5));
}

TEST_F(RixRNGTest, NoPointsNeedNoArrays) {
    RixRNG rng(nullptr, 0);
    rng.DrawSamples1D(nullptr);
    rng.DrawSamples2D(nullptr);
    rng.DrawSamples3D(nullptr);
    rng.GenerateSamples1D(nullptr);
    rng.GenerateSamples2D(nullptr);
    rng.GenerateSamples3D(nullptr);
    rng.NewDomains(kBxdf, nullptr);
    rng.NewDomainsDistrib(kBxdf, 0, nullptr);
    rng.NewDomainsSplit(kBxdf, 2, nullptr);
    const RixRNG child(rng, kBxdf, nullptr, RixRNG::Split{2});
    EXPECT_EQ(child.numPts, 0u);
}

TEST_F(RixRNGTest, OneDimensionAndTwoOfOneContextMakeThePointOfThree) {
    const RixRNG rng(contexts, kPoints);
    for (unsigned sampleid : {0u, 255u, 4096u, 196607u, 196608u, 0xffffffffu}) {
        contexts[0].sampleid = sampleid;
        const RtFloat3 xyz = rng.DrawSample3D(0);
        EXPECT_EQ(rng.DrawSample2D(0), RtFloat2(xyz.x, xyz.y));
        EXPECT_EQ(rng.DrawSample1D(0), xyz.z);
    }
}

TEST_F(RixRNGTest, OutOfOrderAccessGivesTheSameValues) {
    constexpr unsigned n = 3 * 4096;
    RixRNG rng(contexts, 1);
    contexts[0].sampleid = 0;
    std::vector<RtFloat3> inOrder(n);
    for (RtFloat3& xi : inOrder) xi = rng.GenerateSample3D(0);
    for (unsigned i = 0; i < n; ++i) {
        const unsigned sampleid = i * 7919 % n; // a prime that does not divide n: visits all
        contexts[0].sampleid = sampleid;
        ASSERT_EQ(rng.DrawSample3D(0), inOrder[sampleid]);
    }
}

// ---- the blocks of a pattern

TEST_F(RixRNGTest, SamplesNearTheEndOf32BitsAreDefined) {
    RixRNG rng(contexts, 1);
    contexts[0].sampleid = 0xfffffffeu;
    for (int i = 0; i < 4; ++i) { // steps over 2^32 to sample 0 and on
        const unsigned sampleid = contexts[0].sampleid;
        const RtFloat3 xi = rng.GenerateSample3D(0);
        EXPECT_EQ(xi, RixProgressiveSample3D(contexts[0].patternid, sampleid));
        EXPECT_TRUE(xi.x >= 0 && xi.x < 1 && xi.y >= 0 && xi.y < 1 && xi.z >= 0 && xi.z < 1);
    }
    EXPECT_EQ(contexts[0].sampleid, 2u);
}

std::vector<float> samplesOf(unsigned pattern, unsigned first, unsigned count, unsigned step = 1) {
    std::vector<float> values;
    for (unsigned i = 0; i < count; ++i) {
        values.push_back(RixProgressiveSample1D(pattern, first + i * step));
    }
    return values;
}

// A block that took the table of the one before would have its values too.
TEST(Blocks, Sample4096IsFromAnotherTable) {
    for (unsigned pattern : {0u, 1u, 0x12345678u, 0xffffffffu}) {
        std::vector<float> first = samplesOf(pattern, 0, 4096);
        std::vector<float> second = samplesOf(pattern, 4096, 4096);
        std::sort(first.begin(), first.end());
        std::sort(second.begin(), second.end());
        unsigned common = 0;
        for (const float v : second) common += std::binary_search(first.begin(), first.end(), v);
        EXPECT_LT(common, 40u) << "1 is expected of random 24-bit values";
    }
}

TEST(Blocks, All48BlocksOfAPatternUseDifferentTables) {
    for (unsigned pattern = 0; pattern < 100000; ++pattern) {
        const uint32_t seed = wellstrat::patternSeed(pattern);
        std::vector<bool> used(wellstrat::kTableCount, false);
        for (unsigned block = 0; block < 48; ++block) {
            const unsigned table = wellstrat::tableOfBlock(seed, block);
            ASSERT_LT(table, wellstrat::kTableCount);
            ASSERT_FALSE(used[table]) << "pattern " << pattern << ", block " << block;
            used[table] = true;
        }
    }
}

TEST(Blocks, EachIsStratifiedByItself) {
    for (unsigned pattern : {0u, 0xdeb189cfu}) {
        for (unsigned block = 0; block < 48; ++block) {
            EXPECT_TRUE(fillsStrata(samplesOf(pattern, block * 4096, 4096))) << "block " << block;
            EXPECT_TRUE(fillsStrata(samplesOf(pattern, block * 4096 + 256, 256)));
        }
    }
}

TEST(Blocks, Sample196607IsTheLastStratified) {
    for (unsigned pattern : {0u, 1u, 2u}) {
        EXPECT_TRUE(fillsStrata(samplesOf(pattern, 196608 - 16, 16)));
        EXPECT_FALSE(fillsStrata(samplesOf(pattern, 196608, 16)));
        EXPECT_EQ(RixProgressiveSample1D(pattern, 196608), HashToRandom(pattern, 196608));
        EXPECT_NE(RixProgressiveSample1D(pattern, 196607), HashToRandom(pattern, 196607));
    }
}

// ---- the three kinds of domains

TEST(Domains, TwoRaysSplitByFourEqualEightRaysWithOneSecondary) {
    const auto camera = [](unsigned sampleid) {
        return wellstrat::cameraContext(3, 4, 5, sampleid);
    };
    std::vector<RtFloat3> eightRays;
    for (unsigned ray = 0; ray < 8; ++ray) {
        SampleCtx sc = camera(ray);
        SampleCtx child;
        const RixRNG rng(RixRNG(&sc, 1), kBxdf, &child);
        eightRays.push_back(rng.DrawSample3D(0));
    }
    std::vector<RtFloat3> twoRays;
    for (unsigned ray = 0; ray < 2; ++ray) {
        SampleCtx sc = camera(ray);
        SampleCtx child = RixRNG(&sc, 1).NewDomainSplit(0, kBxdf, 4);
        RixRNG rng(&child, 1);
        for (int secondary = 0; secondary < 4; ++secondary) {
            twoRays.push_back(rng.GenerateSample3D(0));
        }
    }
    EXPECT_EQ(twoRays, eightRays);
}

TEST(Domains, SplitByOneEqualsNewDomain) {
    for (unsigned sampleid : {0u, 1u, 4095u, 0xffffffffu}) {
        const SampleCtx sc{123, sampleid};
        expectEqual(sc.NewDomainSplit(kBxdf, 1), sc.NewDomain(kBxdf));
    }
}

TEST(Domains, SplitMultipliesTheSampleidModulo32Bits) {
    expectEqual(SampleCtx{9, 7}.NewDomainSplit(kBxdf, 6),
                {SampleCtx{9, 0}.NewDomain(kBxdf).patternid, 42});
    EXPECT_EQ((SampleCtx{9, 0x80000001u}.NewDomainSplit(kBxdf, 4).sampleid), 4u);
    EXPECT_EQ((SampleCtx{9, 7}.NewDomainSplit(kBxdf, 0).sampleid), 0u);
}

TEST(Domains, DistributionGivesEveryIterationAStratifiedSetOfItsOwn) {
    constexpr unsigned iterations = 1000;
    std::set<unsigned> patterns;
    for (unsigned iteration = 0; iteration < iterations; ++iteration) {
        const SampleCtx child = SampleCtx{55, iteration}.NewDomainDistrib(kLight, 0);
        EXPECT_EQ(child.sampleid, 0u);
        EXPECT_TRUE(fillsStrata(samplesOf(child.patternid, 0, 16)));
        EXPECT_TRUE(fillsStrata(samplesOf(child.patternid, 0, 64)));
        patterns.insert(child.patternid);
    }
    EXPECT_EQ(patterns.size(), iterations);
    EXPECT_EQ((SampleCtx{55, 3}.NewDomainDistrib(kLight, 17).sampleid), 17u);
}

// A distribution that ignored the sampleid would give correlation 1. The sets of iterations whose
// numbers differ by a power of two must not depend on each other either.
TEST(Domains, DistributionsOfDifferentIterationsAreUncorrelated) {
    constexpr unsigned n = 1u << 14;
    const auto draw = [](unsigned pattern, unsigned iteration) {
        const SampleCtx child = SampleCtx{pattern, iteration}.NewDomainDistrib(kLight, 0);
        return RixProgressiveSample1D(child.patternid, child.sampleid);
    };
    // Samples that are all the same correlate, but for those near the mean: hence several patterns.
    for (const unsigned pattern : {55u, 56u, 57u, 58u}) {
        for (unsigned distance = 1; distance <= 4096; distance *= 8) {
            std::vector<float> a, b;
            for (unsigned i = 0; i < n; ++i) {
                a.push_back(draw(pattern, i));
                b.push_back(draw(pattern, i + distance));
            }
            EXPECT_LT(std::abs(correlation(a, b)), correlationBound(n))
                << "pattern " << pattern << ", distance " << distance;
        }
    }
}

TEST(Domains, DistributionDiffersFromThePlainDomain) {
    for (unsigned s : {0u, 1u, 0xffffffffu}) {
        const SampleCtx sc{55, s};
        EXPECT_NE(sc.NewDomainDistrib(kLight, s).patternid, sc.NewDomain(kLight).patternid);
        EXPECT_NE(sc.NewDomainDistrib(kLight, s).patternid,
                  sc.NewDomainDistrib(kBxdf, s).patternid);
    }
}

TEST(Domains, SiblingsWithTheSameScrambleAreEqual) {
    const SampleCtx sc{1234, 56};
    expectEqual(sc.NewDomain(kBxdf), sc.NewDomain(kBxdf));
    expectEqual(sc.NewDomainDistrib(kBxdf, 2), sc.NewDomainDistrib(kBxdf, 2));
    expectEqual(sc.NewDomainSplit(kBxdf, 2), sc.NewDomainSplit(kBxdf, 2));
}

TEST(Domains, SiblingsWithDifferentScramblesAreUncorrelatedOverPixels) {
    constexpr unsigned n = 1u << 16;
    const auto overPixels = [](Scramble scramble, auto coordinate) {
        std::vector<float> values;
        for (unsigned i = 0; i < n; ++i) {
            const int x = static_cast<int>(i % 256), y = static_cast<int>(i / 256);
            const SampleCtx sc = wellstrat::cameraContext(x, y, 0, 11).NewDomain(scramble);
            values.push_back(coordinate(RixProgressiveSample3D(sc.patternid, sc.sampleid)));
        }
        return values;
    };
    const auto x = [](RtFloat3 p) { return p.x; };
    const auto y = [](RtFloat3 p) { return p.y; };
    const auto z = [](RtFloat3 p) { return p.z; };
    const std::vector<float> a = overPixels(static_cast<Scramble>(0), x);
    for (unsigned scramble : {1u, 2u, 0x80000000u, 0xffffffffu, 0x2d96c92bu}) {
        const auto sibling = static_cast<Scramble>(scramble);
        EXPECT_LT(std::abs(correlation(a, overPixels(sibling, x))), correlationBound(n));
        EXPECT_LT(std::abs(correlation(a, overPixels(sibling, y))), correlationBound(n));
        EXPECT_LT(std::abs(correlation(a, overPixels(sibling, z))), correlationBound(n));
    }
}

// Within a pixel the samples of two siblings are paired by their sampleid. An order that is not
// shuffled, or shuffled alike, pairs them in lockstep.
TEST(Domains, SiblingsWithDifferentScramblesAreUncorrelatedWithinAPixel) {
    constexpr unsigned n = 4096;
    for (unsigned pixel = 0; pixel < 200; ++pixel) {
        const SampleCtx sc{pixel, 0};
        const std::vector<float> a = samplesOf(sc.NewDomain(kBxdf).patternid, 0, n);
        const std::vector<float> b = samplesOf(sc.NewDomain(kLight).patternid, 0, n);
        EXPECT_LT(std::abs(correlation(a, b)), correlationBound(n)) << "pixel " << pixel;
    }
}

/// A batch of any size draws and derives what its points do one by one.
TEST(RixRNG, FewPointsDrawWhatManyDo) {
    constexpr unsigned kMost = 20;
    SampleCtx contexts[kMost], split[kMost], distrib[kMost];
    for (unsigned i = 0; i < kMost; ++i) contexts[i] = {HashToUnsigned(3, i), i * i * i * 61};
    for (unsigned n = 0; n <= kMost; ++n) {
        const RixRNG rng(contexts, n);
        float z[kMost];
        RtFloat2 xy[kMost];
        RtFloat3 xyz[kMost];
        rng.DrawSamples1D(z);
        rng.DrawSamples2D(xy);
        rng.DrawSamples3D(xyz);
        const RixRNG bySplit(rng, kBxdf, split, RixRNG::Split{3});
        const RixRNG byDistrib(rng, kBxdf, distrib, RixRNG::Distrib{3});
        for (unsigned i = 0; i < n; ++i) {
            const SampleCtx sc = contexts[i];
            EXPECT_EQ(z[i], RixProgressiveSample1D(sc.patternid, sc.sampleid)) << n << " " << i;
            EXPECT_EQ(xy[i], RixProgressiveSample2D(sc.patternid, sc.sampleid)) << n << " " << i;
            EXPECT_EQ(xyz[i], RixProgressiveSample3D(sc.patternid, sc.sampleid)) << n << " " << i;
            expectEqual(split[i], sc.NewDomainSplit(kBxdf, 3));
            expectEqual(distrib[i], sc.NewDomainDistrib(kBxdf, 3));
        }
    }
}

} // namespace
