// SPDX-License-Identifier: Apache-2.0
//
// Arrays that functions are given: what is accepted, and what ends the program before anything is
// written.

#include "RixRNG.h"
#include "RixRNGProgressive.h"
#include "wellstrat/batch.h"
#include "wellstrat/joint.h"

#include <gtest/gtest.h>

#include <array>
#include <type_traits>
#include <vector>

namespace {

using SampleCtx = RixRNG::SampleCtx;
using wellstrat::ArrayArgument;

constexpr RixRNG::Scramble kScramble{0x2d96c92b};

// A type like those of other libraries.
struct Span {
    RtFloat2* start;
    unsigned count;
    RtFloat2* data() const { return start; }
    unsigned size() const { return count; }
};

template <class T, class Argument>
constexpr bool kAccepts = std::is_convertible<Argument, ArrayArgument<T>>::value;

static_assert(kAccepts<float, float*> && kAccepts<float, std::nullptr_t>);
static_assert(kAccepts<float, std::vector<float>&> && kAccepts<float, std::array<float, 3>&>);
static_assert(kAccepts<float, float (&)[3]> && kAccepts<RtFloat2, Span>);
static_assert(kAccepts<const unsigned, const std::vector<unsigned>&>);
static_assert(kAccepts<const unsigned, unsigned (&)[3]> && kAccepts<const unsigned, unsigned*>);
static_assert(!kAccepts<float, const float*> && !kAccepts<float, const std::vector<float>&>);
static_assert(!kAccepts<float, const float (&)[3]> && !kAccepts<float, double*>);
static_assert(!kAccepts<RtFloat2, std::vector<float>&> && !kAccepts<float, int>);

// Temporaries that own nothing, signed sizes, and what is no array of T.
struct Derived : RtFloat2 {
    int more;
};
struct Signed {
    std::vector<float> values;
    float* data() { return values.data(); }
    int size() const { return -1; }
};
struct Both {
    float* data() const { return nullptr; }
    unsigned size() const { return 0; }
    operator float*() const { return nullptr; } // NOLINT(google-explicit-constructor)
};
static_assert(!kAccepts<float, std::vector<float>> && kAccepts<const float, std::vector<float>>);
static_assert(!kAccepts<RtFloat2, std::vector<Derived>&> && kAccepts<float, Signed&>);
static_assert(kAccepts<float, Both> && kAccepts<SampleCtx, SampleCtx*&>);

class ArrayArgumentTest : public testing::Test {
protected:
    void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

    SampleCtx contexts[4] = {{11, 0}, {22, 1}, {33, 2}, {44, 3}};
    const RixRNG rng{contexts, 4};
};
using ArrayArgumentDeathTest = ArrayArgumentTest;

TEST_F(ArrayArgumentTest, EveryKindOfArrayGetsTheSameSamples) {
    RtFloat2 array[4], memory[4];
    std::vector<RtFloat2> vector(4);
    std::array<RtFloat2, 5> larger{};
    rng.DrawSamples2D(array);
    rng.DrawSamples2D(&memory[0]);
    rng.DrawSamples2D(vector);
    rng.DrawSamples2D(larger);
    for (unsigned i = 0; i < 4; ++i) {
        EXPECT_EQ(array[i], rng.DrawSample2D(i));
        EXPECT_EQ(memory[i], array[i]);
        EXPECT_EQ(vector[i], array[i]);
        EXPECT_EQ(larger[i], array[i]);
    }
    rng.DrawSamples2D(3, Span{memory, 3});
    std::vector<SampleCtx> children(4);
    EXPECT_EQ(RixRNG(rng, kScramble, children).sampleCtxArray, children.data());
    EXPECT_EQ(RixRNG(children, 4).sampleCtxArray, children.data());
}

extern SampleCtx someContexts[]; // NOLINT(modernize-avoid-c-arrays)

TEST_F(ArrayArgumentTest, ArraysOfUnknownSizeAndNothingAreAccepted) {
    EXPECT_EQ(RixRNG(someContexts, 2).sampleCtxArray, someContexts);
    EXPECT_EQ(RixRNG(NULL, 0).numPts, 0u); // NOLINT(modernize-use-nullptr)
    EXPECT_EQ(RixRNG(nullptr, 0).numPts, 0u);
    rng.DrawSamples2D(0, 0); // NOLINT(modernize-use-nullptr)
}
SampleCtx someContexts[2];

TEST_F(ArrayArgumentDeathTest, TooSmallForDraws) {
    RixRNG own(contexts, 4);
    float one[3] = {7, 7, 7};
    std::vector<RtFloat2> two(3, RtFloat2(7, 7));
    std::array<RtFloat3, 3> three{};
    EXPECT_DEATH(rng.DrawSamples1D(one),
                 "^wellstrat: DrawSamples1D: the array has 3 elements and needs 4\n$");
    EXPECT_DEATH(rng.DrawSamples2D(two), "DrawSamples2D: the array has 3 elements and needs 4");
    EXPECT_DEATH(rng.DrawSamples3D(three), "DrawSamples3D: the array has 3 elements and needs 4");
    EXPECT_DEATH(rng.DrawSamples2D(4, two), "has 3 elements and needs 4");
    Signed none;
    EXPECT_DEATH(rng.DrawSamples1D(none), "has 0 elements and needs 4");
    EXPECT_DEATH(own.GenerateSamples1D(one), "has 3 elements and needs 4");
    EXPECT_DEATH(own.GenerateSamples2D(two),
                 "GenerateSamples2D: the array has 3 elements and needs 4");
    EXPECT_DEATH(own.GenerateSamples3D(three), "has 3 elements and needs 4");
    const wellstrat::JointProgressive joint;
    EXPECT_DEATH(RixRNG(contexts, 4, &joint).DrawSamples2D(two), "has 3 elements and needs 4");
    rng.DrawSamples2D(3, two);
}

TEST_F(ArrayArgumentDeathTest, TooSmallForDomains) {
    SampleCtx three[3];
    std::vector<SampleCtx> none;
    const std::vector<unsigned> indices{0, 1, 2};
    const char* const words = "RixRNG: the array has 3 elements and needs 4";
    EXPECT_DEATH(RixRNG(three, 4), words);
    EXPECT_DEATH(RixRNG(rng, three, 4), words);
    EXPECT_DEATH(RixRNG(&rng, three, 4), words);
    EXPECT_DEATH(RixRNG(rng, kScramble, three), words);
    EXPECT_DEATH(RixRNG(rng, kScramble, three, RixRNG::Split{2}), words);
    EXPECT_DEATH(RixRNG(&rng, kScramble, three, RixRNG::Distrib{0}), words);
    EXPECT_DEATH(RixRNG(rng, indices, 4, contexts), words);
    EXPECT_DEATH(RixRNG(rng, indices, 3, none), "has 0 elements and needs 3");
    EXPECT_DEATH(RixRNG(rng, kScramble, indices, 4, contexts), words);
    EXPECT_DEATH(RixRNG(rng, kScramble, indices, 3, none, RixRNG::Split{2}), "has 0 elements");
    EXPECT_DEATH(rng.NewDomains(kScramble, three), "NewDomains: the array has 3 elements");
    EXPECT_DEATH(rng.NewDomainsSplit(kScramble, 2, three), "NewDomainsSplit: the array has 3");
    EXPECT_DEATH(rng.NewDomainsDistrib(kScramble, 0, three), "NewDomainsDistrib: the array has 3");
}

TEST_F(ArrayArgumentDeathTest, TooSmallForFunctionsOverArrays) {
    const std::vector<SampleCtx> parents(contexts, contexts + 4);
    const std::vector<SampleCtx> few(3);
    std::vector<SampleCtx> children(3);
    std::vector<float> one(3), enough(4);
    std::vector<RtFloat2> two(3);
    std::vector<RtFloat3> three(3);
    const wellstrat::Order order;
    EXPECT_DEATH(wellstrat::drawSamples1D(4, few, enough), "drawSamples1D: .* has 3 .* needs 4");
    EXPECT_DEATH(wellstrat::drawSamples1D(4, parents, one), "drawSamples1D: .* has 3 .* needs 4");
    EXPECT_DEATH(wellstrat::drawSamples2D(4, parents, two), "drawSamples2D: .* has 3 .* needs 4");
    EXPECT_DEATH(wellstrat::generateSamples3D(4, contexts, three), "generateSamples3D: .* needs 4");
    EXPECT_DEATH(wellstrat::drawJointSamples2D(4, parents, order, two), "drawJointSamples2D: ");
    EXPECT_DEATH(wellstrat::drawSequenceSamples2D(4, parents, order, two), "drawSequenceSamples2D");
    EXPECT_DEATH(wellstrat::drawBlueSamples3D(4, parents, order, three), "drawBlueSamples3D: ");
    EXPECT_DEATH(wellstrat::newDomains(4, parents, kScramble, children), "newDomains: .* needs 4");
    EXPECT_DEATH(wellstrat::newBlueDomainsSplit(4, parents, kScramble, 2, children), "has 3");
    EXPECT_DEATH(wellstrat::hashToRandom(4, parents, one), "hashToRandom: .* has 3 .* needs 4");
    EXPECT_DEATH(RixProgressiveSamples2D(4, parents, two), "drawSamples2D: .* has 3 .* needs 4");
    wellstrat::drawSamples2D(3, parents, two);
    EXPECT_EQ(two[2], rng.DrawSample2D(2));
}

/// Slots and splits that no derivation gives.
TEST_F(ArrayArgumentDeathTest, OrdersOutOfRange) {
    const wellstrat::JointProgressive joint;
    RixRNG slot(contexts, 4, &joint);
    RtFloat2 xis[4];
    slot.order.slot = 17;
    EXPECT_DEATH(slot.DrawSamples2D(xis),
                 "wellstrat: an order has slot 17 under splits by 1; there "
                 "are slots 0 to 15 and splits by 1 to 256");
    slot.order = wellstrat::jointOrder(3);
    slot.order.splits = 257;
    EXPECT_DEATH(slot.DrawSamples2D(xis), "an order has slot 3 under splits by 257");
    slot.order.splits = 0;
    EXPECT_DEATH(slot.DrawSample2D(0), "an order has slot 3 under splits by 0");
    EXPECT_DEATH(slot.DrawSample1D(0), "an order has slot 3 under splits by 0");
    EXPECT_DEATH(slot.DrawSample3D(0), "an order has slot 3 under splits by 0");
}

} // namespace
