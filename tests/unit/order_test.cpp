// SPDX-License-Identifier: Apache-2.0
//
// Orders: how one follows from its parent's, and what RixRNGs make of them.

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace wellstrat {
namespace {

constexpr Scramble kOrdinary{0x2d96c92b};

constexpr Order order(unsigned slot, unsigned splits, uint32_t tag = 0) {
    Order result;
    result.slot = static_cast<uint16_t>(slot);
    result.splits = static_cast<uint16_t>(splits);
    result.tag = tag;
    return result;
}

constexpr Order kRoot{};
static_assert(kRoot == order(kJointSlots, 1));
static_assert(deriveOrder(kRoot, kOrdinary, 1) == kRoot);
static_assert(deriveOrder(kRoot, jointScramble(3), 4) == order(3, 4));
static_assert(deriveOrder(order(3, 4), kOrdinary, 2) == order(kJointSlots, 8));
static_assert(deriveOrder(order(3, 4, 7), jointScramble(15), 64) == order(15, 256, 7));
static_assert(deriveOrder(kRoot, jointScramble(16), 1) == kRoot);
static_assert(jointOrder(5) == order(5, 1) && jointOrder(5, 12) == order(5, 12));
static_assert(jointOrder(16) == kRoot && jointOrder(5, 257) == order(kJointSlots, 0));

/// What an order means in one line of arithmetic: a chain of scrambles and splits since the camera.
struct Chain {
    uint64_t product = 1;
    bool lost = false;
    unsigned slot = kJointSlots;

    void derive(Scramble scramble, unsigned split) {
        product = split == 0 ? product : product * split;
        lost = lost || split == 0 || product > 256;
        const uint64_t offset =
            uint64_t{static_cast<unsigned>(scramble)} - static_cast<unsigned>(jointScramble(0));
        slot = !lost && offset < 16 ? static_cast<unsigned>(offset) : 16;
    }
};

TEST(Order, FollowsFromTheChainOfDerivations) {
    const unsigned splits[] = {1, 1, 1, 1, 2, 3, 4, 16, 256, 257, 0, 0x80000000u, 0xffffffffu};
    for (uint32_t path = 0; path < 20000; ++path) {
        Chain chain;
        Order derived;
        derived.tag = path;
        for (uint32_t depth = 0; depth < 6; ++depth) {
            const uint32_t hash = hashPair(path, depth);
            const Scramble scramble = hash & 1u ? jointScramble(hash >> 8 & 31u) : Scramble{hash};
            const unsigned split = splits[scaleToRange(mixBits(hash), 13)];
            chain.derive(scramble, split);
            derived = deriveOrder(derived, scramble, split);
            ASSERT_EQ(derived.slot, chain.slot) << path << " " << depth;
            ASSERT_EQ(derived.splits, chain.lost ? 0 : chain.product);
            ASSERT_EQ(derived.tag, path);
            if (chain.lost) chain.product = 1; // it stays lost, and must not overflow
        }
    }
}

class OrderOfRixRNG : public testing::Test {
protected:
    SampleCtx contexts[4] = {{11, 0}, {22, 1}, {33, 2}, {44, 3}}, children[4] = {};
};

TEST_F(OrderOfRixRNG, IsDerivedWithAndWithoutAGenerator) {
    const JointProgressive joint;
    const LongProgressive longer;
    const BlueProgressive blue;
    const Generator* const generators[] = {nullptr, &joint, &longer, &blue};
    for (const Generator* generator : generators) {
        const RixRNG camera(contexts, 4, generator);
        EXPECT_EQ(camera.order, kRoot);
        const RixRNG slot(camera, jointScramble(2), children, RixRNG::Split{3});
        EXPECT_EQ(slot.order, jointOrder(2, 3));
        EXPECT_EQ(RixRNG(slot, kOrdinary, children).order, order(kJointSlots, 3));
        EXPECT_EQ(RixRNG(slot, kOrdinary, children, RixRNG::Distrib{0}).order,
                  order(kJointSlots, 0));
        EXPECT_EQ(RixRNG(slot, children, 2).order, order(kJointSlots, 3));
        EXPECT_EQ(RixRNG(&slot, children, 2).order, order(kJointSlots, 3));
        EXPECT_EQ(RixRNG(RixRNG(camera, jointScramble(2), children), children, 2).order, kRoot);
        const RixRNG lost(camera, kOrdinary, children, RixRNG::Distrib{0});
        EXPECT_EQ(RixRNG(lost, children, 2).order, order(kJointSlots, 0));
    }
}

TEST_F(OrderOfRixRNG, SubsetsAreDerived) {
    const JointProgressive joint;
    const RixRNG camera(contexts, 4, &joint);
    const RixRNG slot(camera, jointScramble(2), children, RixRNG::Split{3});
    const unsigned indices[] = {3, 0, 3};
    SampleCtx some[3], again[3];
    RixRNG subset(slot, indices, 3, some);
    EXPECT_EQ(subset.order, slot.order);
    EXPECT_EQ(subset.generator, &joint);
    ASSERT_EQ(subset.numPts, 3u);
    for (unsigned k = 0; k < 3; ++k) {
        EXPECT_EQ(subset.DrawSample3D(k), slot.DrawSample3D(indices[k]));
    }
    const RtFloat3 before = slot.DrawSample3D(3);
    RtFloat2 xis[3];
    subset.GenerateSamples2D(xis);
    EXPECT_EQ(slot.DrawSample3D(3), before) << "the parent stays as it is";

    const RixRNG derived(camera, jointScramble(2), indices, 3, again, RixRNG::Split{3});
    EXPECT_EQ(derived.order, slot.order);
    for (unsigned k = 0; k < 3; ++k) {
        EXPECT_EQ(derived.DrawSample3D(k), slot.DrawSample3D(indices[k]));
    }
    const RixRNG plain(&camera, kOrdinary, indices, 3, again);
    const RixRNG distributed(camera, kOrdinary, indices, 2, some, RixRNG::Distrib{5});
    for (unsigned k = 0; k < 2; ++k) {
        const SampleCtx sc = contexts[indices[k]];
        EXPECT_EQ(again[k].patternid, sc.NewDomain(kOrdinary).patternid);
        EXPECT_EQ(again[k].sampleid, sc.sampleid);
        EXPECT_EQ(some[k].patternid, sc.NewDomainDistrib(kOrdinary, 5).patternid);
        EXPECT_EQ(some[k].sampleid, 5u);
    }
    EXPECT_EQ(RixRNG(slot, indices, 0, some).numPts, 0u);
}

/// New domains in place are another domain, and no longer the slot.
TEST_F(OrderOfRixRNG, FollowsNewDomainsInPlace) {
    const JointProgressive joint;
    const RixRNG camera(contexts, 4, &joint);
    RixRNG rng(camera, jointScramble(2), children, RixRNG::Split{3});
    SampleCtx elsewhere[4];
    rng.NewDomains(kOrdinary, elsewhere);
    EXPECT_EQ(rng.order, jointOrder(2, 3));
    rng.NewDomains(kOrdinary, children);
    EXPECT_EQ(rng.order, order(kJointSlots, 3));
    rng.NewDomainsSplit(jointScramble(4), 2, rng.sampleCtxArray);
    EXPECT_EQ(rng.order, jointOrder(4, 6));
    rng.NewDomainsDistrib(kOrdinary, 0, children);
    EXPECT_EQ(rng.order, order(kJointSlots, 0));
}

/// As integrators do whose paths end: in place, to the front.
TEST_F(OrderOfRixRNG, IncreasingIndicesCompactInPlace) {
    const RixRNG camera(contexts, 4);
    const unsigned alive[] = {1, 3};
    const RixRNG rest(camera, alive, 2, contexts);
    EXPECT_EQ(contexts[0].patternid, 22u);
    EXPECT_EQ(contexts[1].patternid, 44u);
    EXPECT_EQ(rest.numPts, 2u);
}

} // namespace
} // namespace wellstrat
