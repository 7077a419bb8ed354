// SPDX-License-Identifier: Apache-2.0
//
// JointProgressive: which domains draw from a slot, which as without a generator, and what a slot's
// samples are.

#include "RixRNG.h"
#include "wellstrat/joint.h"
#include "wellstrat/random_generator.h"

#include "joint_reference.h"

#include <gtest/gtest.h>

#include <vector>

namespace wellstrat::test {
namespace {

constexpr Scramble kOrdinary = static_cast<Scramble>(0x2d96c92bu);
constexpr Scramble kOther = static_cast<Scramble>(0x3917fe2eu);

/// Contexts of many patterns, at sampleids in block 0, later, near the end of the tables, and
/// beyond.
std::vector<SampleCtx> someContexts() {
    std::vector<SampleCtx> contexts;
    for (uint32_t i = 0; i < 48; ++i) {
        for (const uint32_t sampleid : {0u, 1u, 7u + i, 4095u, 4096u, hashPair(i, 1) % 196608u}) {
            contexts.push_back({hashPair(2, i), sampleid});
        }
        contexts.push_back({hashPair(3, i), kStratifiedSamples + i - 24});
        contexts.push_back({hashPair(3, i), 0u - i});
    }
    return contexts;
}

/// The slot and the split that a RixRNG draws from.
struct Domain {
    unsigned slot, split;
};
bool operator==(Domain a, Domain b) { return a.slot == b.slot && a.split == b.split; }

constexpr Domain kNone{kJointSlots, 1};
constexpr Domain kLost{kJointSlots, 0};

Domain domainOf(const RixRNG& rng) {
    EXPECT_NE(dynamic_cast<const JointProgressive*>(rng.generator), nullptr);
    return {rng.order.slot, rng.order.splits};
}

class JointTest : public testing::Test {
protected:
    const JointProgressive joint;
    std::vector<SampleCtx> contexts = someContexts();
    const unsigned n = static_cast<unsigned>(contexts.size());
    const RixRNG camera{contexts.data(), n, &joint};
    std::vector<SampleCtx> a = contexts, b = contexts, c = contexts;

    /// That `rng` draws the default's samples of its contexts.
    static void expectPadded(const RixRNG& rng) {
        const RixRNG padded(rng.sampleCtxArray, rng.numPts);
        std::vector<Float3> xis(rng.numPts), expected(rng.numPts);
        rng.DrawSamples3D(xis.data());
        padded.DrawSamples3D(expected.data());
        for (unsigned i = 0; i < rng.numPts; ++i) {
            ASSERT_EQ(xis[i], expected[i]) << i;
            ASSERT_EQ(rng.DrawSample1D(i), expected[i].z);
            ASSERT_EQ(rng.DrawSample2D(i), Float2(expected[i].x, expected[i].y));
        }
    }

    /// That `rng` draws from this slot.
    static void expectDrawsFrom(const RixRNG& rng, Domain domain) {
        EXPECT_EQ(domainOf(rng), domain);
        std::vector<Float3> xis(rng.numPts);
        rng.DrawSamples3D(xis.data());
        for (unsigned i = 0; i < rng.numPts; ++i) {
            const SampleCtx sc = rng.sampleCtxArray[i];
            ASSERT_EQ(xis[i], referenceSample(sc.patternid, sc.sampleid, domain.slot, domain.split))
                << sc.patternid << " " << sc.sampleid;
        }
    }
};

TEST_F(JointTest, TheCameraDrawsPaddedSamples) {
    expectPadded(camera);
    EXPECT_EQ(domainOf(camera), kNone);
}

TEST_F(JointTest, OrdinaryDomainsArePaddedAtAnyDepth) {
    const RixRNG first(camera, kOrdinary, a.data());
    const RixRNG second(first, kOther, b.data(), RixRNG::Split{3});
    const RixRNG third(second, kOrdinary, c.data());
    for (const RixRNG& rng : {first, second, third}) expectPadded(rng);
    EXPECT_EQ(domainOf(third), (Domain{kJointSlots, 3}));
}

TEST_F(JointTest, SlotsAreTakenAtAnyDepth) {
    const RixRNG first(camera, kOrdinary, a.data());
    const RixRNG between(camera, kOrdinary, a.data());
    const RixRNG second(&between, kOther, b.data());
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        expectDrawsFrom(RixRNG(camera, jointScramble(slot), c.data()), {slot, 1});
        expectDrawsFrom(RixRNG(first, jointScramble(slot), c.data()), {slot, 1});
        expectDrawsFrom(RixRNG(&second, jointScramble(slot), c.data()), {slot, 1});
    }
}

TEST_F(JointTest, ASlotIsNotInherited) {
    const RixRNG slot(camera, jointScramble(3), a.data());
    const RixRNG child(slot, kOrdinary, b.data());
    expectPadded(child);
    EXPECT_EQ(domainOf(child), kNone);
    expectDrawsFrom(RixRNG(slot, jointScramble(5), b.data()), {5, 1});
    const RixRNG split(slot, kOrdinary, b.data(), RixRNG::Split{2});
    expectPadded(split);
    EXPECT_EQ(domainOf(split), (Domain{kJointSlots, 2}));
}

TEST_F(JointTest, AViewHasNoSlotAndASubsetTheSameOne) {
    const RixRNG slot(camera, jointScramble(4), a, RixRNG::Split{6});
    const RixRNG view(slot, a.data() + 2, n - 2), viewByPointer(&slot, a, n);
    expectPadded(view);
    expectPadded(viewByPointer);
    EXPECT_EQ(domainOf(view), (Domain{kJointSlots, 6}));
    std::vector<unsigned> odd;
    for (unsigned i = 1; i < n; i += 2) odd.push_back(i);
    expectDrawsFrom(RixRNG(slot, odd, n / 2, b), {4, 6});
    expectDrawsFrom(RixRNG(&slot, odd, n / 2, b), {4, 6});
    expectDrawsFrom(RixRNG(camera, jointScramble(4), odd, n / 2, c, RixRNG::Split{6}), {4, 6});
    expectPadded(RixRNG(slot, kOrdinary, odd, n / 2, c));
}

TEST_F(JointTest, ScramblesBeyondTheSlotsAreOrdinary) {
    for (const unsigned slot : {kJointSlots, kJointSlots + 1, 1000u, 0u - 1u}) {
        const RixRNG child(camera, jointScramble(slot), a.data());
        expectPadded(child);
        EXPECT_EQ(domainOf(child), kNone);
    }
    EXPECT_EQ(static_cast<unsigned>(jointScramble(0)), 0x6a6f696eu);
    EXPECT_EQ(static_cast<unsigned>(jointScramble(15)), 0x6a6f696eu + 15);
}

TEST_F(JointTest, SplitsMultiply) {
    const RixRNG first(camera, kOrdinary, a.data(), RixRNG::Split{4});
    const RixRNG second(first, kOther, b.data());
    expectDrawsFrom(RixRNG(second, jointScramble(1), c.data(), RixRNG::Split{3}), {1, 12});
    const RixRNG slot(first, jointScramble(0), b.data(), RixRNG::Split{2});
    expectDrawsFrom(slot, {0, 8});
    expectDrawsFrom(RixRNG(slot, jointScramble(2), c.data(), RixRNG::Split{32}), {2, 256});
}

// 2^32 / 8 overflows in 32 bits to a product that would look small.
TEST_F(JointTest, TooManyBranchesArePadded) {
    const RixRNG first(camera, kOrdinary, a.data(), RixRNG::Split{8});
    for (const unsigned split : {33u, 256u, 257u, 0x20000000u, 0x20000001u, 0xffffffffu}) {
        const RixRNG child(first, jointScramble(0), b.data(), RixRNG::Split{split});
        EXPECT_EQ(domainOf(child), kLost) << split;
        expectPadded(child);
        EXPECT_EQ(domainOf(RixRNG(child, jointScramble(0), c.data())), kLost);
    }
    EXPECT_EQ(domainOf(RixRNG(camera, kOrdinary, b.data(), RixRNG::Split{257})), kLost);
    EXPECT_EQ(domainOf({camera, jointScramble(9), b.data(), RixRNG::Split{256}}), (Domain{9, 256}));
}

TEST_F(JointTest, DistributionIsPaddedAndSoIsAllBelow) {
    for (const RixRNG& child : {RixRNG(camera, kOrdinary, a.data(), RixRNG::Distrib{0}),
                                RixRNG(camera, jointScramble(0), b.data(), RixRNG::Distrib{5}),
                                RixRNG(camera, jointScramble(0), b.data(), RixRNG::Split{0})}) {
        EXPECT_EQ(domainOf(child), kLost);
        expectPadded(child);
        const RixRNG below(child, jointScramble(1), c.data());
        EXPECT_EQ(domainOf(below), kLost);
        expectPadded(below);
    }
}

TEST_F(JointTest, OtherGeneratorsTakeNoNoticeOfSlots) {
    const RandomGenerator random;
    const RixRNG rng(contexts.data(), n, &random);
    EXPECT_EQ(RixRNG(rng, jointScramble(0), a.data()).generator, &random);
    const RixRNG null(contexts.data(), n);
    EXPECT_EQ(RixRNG(null, jointScramble(0), a.data()).generator, nullptr);
    expectPadded(RixRNG(null, jointScramble(0), a.data()));
}

TEST_F(JointTest, GenerateStepsToTheNextSample) {
    RixRNG slot(camera, jointScramble(2), a.data(), RixRNG::Split{2});
    std::vector<Float2> xis(n);
    for (unsigned step = 0; step < 5; ++step) {
        const std::vector<SampleCtx> before = a;
        slot.GenerateSamples2D(xis.data());
        for (unsigned i = 0; i < n; ++i) {
            ASSERT_EQ(a[i].sampleid, before[i].sampleid + 1);
            const Float3 expected = referenceSample(before[i].patternid, before[i].sampleid, 2, 2);
            ASSERT_EQ(xis[i], Float2(expected.x, expected.y));
        }
    }
}

TEST_F(JointTest, OneDrawAtATimeIsTheBatch) {
    for (const unsigned split : {1u, 2u, 5u}) {
        RixRNG slot(camera, jointScramble(11), a.data(), RixRNG::Split{split});
        std::vector<float> z(n);
        std::vector<Float2> xy(n);
        std::vector<Float3> xyz(n);
        slot.DrawSamples1D(z.data());
        slot.DrawSamples2D(xy.data());
        slot.DrawSamples3D(xyz.data());
        for (unsigned i = 0; i < n; ++i) {
            ASSERT_EQ(slot.DrawSample1D(i), z[i]);
            ASSERT_EQ(slot.DrawSample2D(i), xy[i]);
            ASSERT_EQ(slot.GenerateSample3D(i), xyz[i]);
            ASSERT_EQ(xyz[i], Float3(xy[i].x, xy[i].y, z[i]));
        }
    }
}

class JointSplit : public testing::TestWithParam<unsigned> {};

// Against the definition, computed anew: every slot, many patterns, the first visits and those
// around the edges of blocks, of all that is stratified, and of 32 bits.
TEST_P(JointSplit, SamplesAreThoseOfTheDefinition) {
    const unsigned split = GetParam();
    const uint32_t* words = tables();
    const uint32_t end = kStratifiedSamples - kStratifiedSamples % split;
    ASSERT_EQ(jointStratifiedSamples(split), end);
    std::vector<uint32_t> firsts{0, 256, 4096, 12288, 4096 * split, 4096 * 2 * split, 131072, 0u};
    firsts.insert(firsts.end(), {end, kStratifiedSamples, end / 2, end / 3 * 2, 0x80000000u});
    for (uint32_t i = 0; i < 64; ++i) {
        const uint32_t pattern = hashPair(7, i);
        for (const uint32_t first : firsts) {
            for (uint32_t k = 0; k < 48; ++k) {
                const uint32_t sampleid = first + k - 24;
                const unsigned slot = (i + k) % kJointSlots;
                const Float3 expected = referenceSample(pattern, sampleid, slot, split);
                ASSERT_EQ(jointSample3D(words, pattern, sampleid, slot, split), expected)
                    << "slot " << slot << ", sample " << sampleid << " of " << pattern;
                ASSERT_EQ(jointSample2D(words, pattern, sampleid, slot, split),
                          Float2(expected.x, expected.y));
                ASSERT_EQ(jointSample1D(words, pattern, sampleid, slot, split), expected.z);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Splits, JointSplit,
                         testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 32, 96, 100, 255, 256));

} // namespace
} // namespace wellstrat::test
