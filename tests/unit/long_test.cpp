// SPDX-License-Identifier: Apache-2.0
//
// LongProgressive: which domains draw from a slot and which shuffled samples, through a RixRNG and
// without one, one by one and in batches, and what happens at the end of all samples.

#include "RixRNG.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/sequence_slots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace wellstrat::test {
namespace {

constexpr Scramble kOrdinary = static_cast<Scramble>(0x2d96c92bu);
constexpr Scramble kOther = static_cast<Scramble>(0x3917fe2eu);

const LongProgressive kLong;

/// Contexts of many patterns, at sampleids where tables would end and where they never were.
std::vector<SampleCtx> someContexts() {
    std::vector<SampleCtx> contexts;
    for (uint32_t i = 0; i < 48; ++i) {
        for (const uint32_t sampleid :
             {0u, 1u, 7u + i, 4096u, 0xffffu, 0x10000u, 0x80000000u, 0u - 1u - i, hashPair(i, 1)}) {
            contexts.push_back({hashPair(2, i), sampleid});
        }
    }
    return contexts;
}

class LongTest : public testing::Test {
protected:
    std::vector<SampleCtx> contexts = someContexts();
    const unsigned n = static_cast<unsigned>(contexts.size());
    const RixRNG camera{contexts.data(), n, &kLong};
    std::vector<SampleCtx> a = contexts, b = contexts, c = contexts;

    /// That `rng` draws expected(context), however one draws.
    template <typename Expected>
    static void expectDraws(const RixRNG& rng, Expected expected) {
        const unsigned count = rng.numPts;
        std::vector<float> z(count);
        std::vector<Float2> xy(count);
        std::vector<Float3> xyz(count);
        for (const unsigned few : {std::min(3u, count), count}) { // by a loop, and by vector code
            rng.DrawSamples1D(few, z.data());
            rng.DrawSamples2D(few, xy.data());
            rng.DrawSamples3D(few, xyz.data());
            for (unsigned i = 0; i < few; ++i) {
                const Float3 sample = expected(rng.sampleCtxArray[i]);
                const Float2 firstTwo(sample.x, sample.y);
                ASSERT_EQ(xyz[i], sample) << i;
                ASSERT_EQ(xy[i], firstTwo);
                ASSERT_EQ(z[i], sample.z);
                ASSERT_EQ(rng.DrawSample3D(i), sample);
                ASSERT_EQ(rng.DrawSample2D(i), firstTwo);
                ASSERT_EQ(rng.DrawSample1D(i), sample.z);
                const SampleCtx& sc = rng.sampleCtxArray[i];
                ASSERT_EQ(kLong.OrderedSample3D(sc, i, rng.order), sample);
                ASSERT_EQ(kLong.OrderedSample2D(sc, i, rng.order), firstTwo);
                ASSERT_EQ(kLong.OrderedSample1D(sc, i, rng.order), sample.z);
            }
        }
    }
    static void expectPadded(const RixRNG& rng) {
        EXPECT_EQ(rng.order.slot, kJointSlots);
        expectDraws(rng, [](SampleCtx sc) { return sequenceSample3D(sc.patternid, sc.sampleid); });
    }
    static void expectDrawsFrom(const RixRNG& rng, unsigned slot, unsigned split) {
        EXPECT_EQ(rng.order, jointOrder(slot, split));
        expectDraws(rng, [=](SampleCtx sc) {
            return jointSequenceSample3D(sc.patternid, sc.sampleid, slot, split);
        });
    }
};

TEST_F(LongTest, OrdinaryDomainsArePaddedAtAnyDepth) {
    const RixRNG first(camera, kOrdinary, a.data());
    const RixRNG second(first, kOther, b.data(), RixRNG::Split{3});
    const RixRNG distributed(camera, kOrdinary, c.data(), RixRNG::Distrib{5});
    for (const RixRNG& rng : {camera, first, second, distributed}) expectPadded(rng);
}

TEST_F(LongTest, SlotsAreTakenAtAnyDepth) {
    const RixRNG first(camera, kOrdinary, a.data());
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        expectDrawsFrom(RixRNG(camera, jointScramble(slot), c.data()), slot, 1);
        expectDrawsFrom(RixRNG(first, jointScramble(slot), c.data()), slot, 1);
    }
    const RixRNG split(first, kOther, b.data(), RixRNG::Split{4});
    expectDrawsFrom(RixRNG(split, jointScramble(1), c.data(), RixRNG::Split{3}), 1, 12);
}

TEST_F(LongTest, WhatIsNoSlotIsPadded) {
    const RixRNG slot(camera, jointScramble(4), a, RixRNG::Split{2});
    expectPadded(RixRNG(slot, kOrdinary, b));
    expectPadded(RixRNG(slot, a.data() + 2, n - 2)); // a view
    expectPadded(RixRNG(camera, jointScramble(kJointSlots), b));
    const RixRNG tooMany(camera, jointScramble(0), b, RixRNG::Split{257});
    expectPadded(tooMany);
    expectPadded(RixRNG(tooMany, jointScramble(0), c));
    const RixRNG distributed(camera, jointScramble(0), b, RixRNG::Distrib{0});
    expectPadded(distributed);
    expectPadded(RixRNG(distributed, jointScramble(1), c));
}

TEST_F(LongTest, ASubsetHasTheSlot) {
    const RixRNG slot(camera, jointScramble(4), a, RixRNG::Split{6});
    std::vector<unsigned> odd;
    for (unsigned i = 1; i < n; i += 2) odd.push_back(i);
    expectDrawsFrom(RixRNG(slot, odd, n / 2, b), 4, 6);
}

// As of a camera's context, without a RixRNG.
TEST_F(LongTest, SamplesWithoutARixRNGArePadded) {
    std::vector<float> z(n);
    std::vector<Float2> xy(n);
    std::vector<Float3> xyz(n);
    kLong.MultiSample1D(n, contexts[0], z.data());
    kLong.MultiSample2D(n, contexts[0], xy.data());
    kLong.MultiSample3D(n, contexts[0], xyz.data());
    for (unsigned i = 0; i < n; ++i) {
        const SampleCtx sc = contexts[i];
        const Float3 expected = sequenceSample3D(sc.patternid, sc.sampleid);
        ASSERT_EQ(kLong.Sample3D(sc, i), expected);
        ASSERT_EQ(kLong.Sample2D(sc, i), Float2(expected.x, expected.y));
        ASSERT_EQ(kLong.Sample1D(sc, i), expected.z);
        ASSERT_EQ(xyz[i], expected);
        ASSERT_EQ(xy[i], Float2(expected.x, expected.y));
        ASSERT_EQ(z[i], expected.z);
    }
}

TEST_F(LongTest, GenerateStepsToTheNextSampleAndFromTheLastToTheFirst) {
    RixRNG rng(a.data(), n, &kLong);
    std::vector<Float2> xis(n);
    for (unsigned step = 0; step < 3; ++step) {
        const std::vector<SampleCtx> before = a;
        rng.GenerateSamples2D(xis.data());
        for (unsigned i = 0; i < n; ++i) {
            ASSERT_EQ(a[i].sampleid, before[i].sampleid + 1);
            ASSERT_EQ(xis[i], sequenceSample2D(before[i].patternid, before[i].sampleid));
        }
    }
    SampleCtx last{7, 0xffffffffu};
    RixRNG end(&last, 1, &kLong);
    end.GenerateSample2D(0);
    EXPECT_EQ(end.DrawSample2D(0), sequenceSample2D(7, 0));
}

// The product of sampleid and split is taken modulo 2^32: the sequence begins anew.
TEST_F(LongTest, SplitsThatOverflowBeginAnew) {
    SampleCtx parent{7, 0x40000001u}, child;
    const RixRNG rng(&parent, 1, &kLong);
    const RixRNG split(rng, kOrdinary, &child, RixRNG::Split{4});
    EXPECT_EQ(child.sampleid, 4u);
    expectPadded(split);
    expectDrawsFrom(RixRNG(rng, jointScramble(3), &child, RixRNG::Split{4}), 3, 4);
}

TEST_F(LongTest, KnowsNothingOfTables) {
    EXPECT_EQ(kLong.source(), Generator::Source::sequence);
    EXPECT_EQ(JointProgressive().source(), Generator::Source::tables);
    const RixRNG tables(contexts.data(), n);
    EXPECT_NE(camera.DrawSample3D(0), tables.DrawSample3D(0));
}

TEST(LongDeathTest, AnOrderThatNobodyDerivedEndsTheProgram) {
    const SampleCtx sc{1, 2};
    Order order;
    order.slot = kJointSlots + 1;
    EXPECT_DEATH(kLong.OrderedSample2D(sc, 0, order), "an order has slot 17 under splits by 1");
    order.slot = 3;
    order.splits = 0;
    EXPECT_DEATH(kLong.OrderedSample1D(sc, 0, order), "an order has slot 3 under splits by 0");
    std::vector<SampleCtx> contexts(64, sc);
    std::vector<Float3> xis(64);
    EXPECT_DEATH(drawSequenceSamples3D(64, contexts.data(), order, xis.data()), "slot 3");
}

} // namespace
} // namespace wellstrat::test
