// SPDX-License-Identifier: Apache-2.0
//
// Generators: who is asked for a sample, with which arguments, and what children inherit.

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <vector>

#ifdef __clang__
#define CONSTANT [[clang::require_constant_initialization]]
#else
#define CONSTANT __constinit
#endif

namespace {

using SampleCtx = RixRNG::SampleCtx;
using Scramble = RixRNG::Scramble;

constexpr Scramble kScramble = static_cast<Scramble>(0x2d96c92bu);

// Generators without state are there before the first constructor of the program runs: the compiler
// refuses these otherwise.
CONSTANT const wellstrat::JointProgressive kJoint;
CONSTANT const wellstrat::LongProgressive kLong;
CONSTANT const wellstrat::BlueProgressive kBlue;

/// Samples that tell what they were asked with, and a record of which domains were derived.
class TellTale : public RixRNG::Generator {
public:
    struct Call {
        RixRNG::Order parent;
        Scramble scramble;
        unsigned split;
    };
    mutable std::vector<Call> calls;

    float Sample1D(const SampleCtx& sc, unsigned i) const override {
        return static_cast<float>(sc.patternid + 1000 * sc.sampleid + 1000000 * i);
    }
    RtFloat2 Sample2D(const SampleCtx& sc, unsigned i) const override {
        return {Sample1D(sc, i), 2.0f};
    }
    RtFloat3 Sample3D(const SampleCtx& sc, unsigned i) const override {
        return {Sample1D(sc, i), 2.0f, 3.0f};
    }
    RixRNG::Order ChildOrder(RixRNG::Order parent, Scramble scramble,
                             unsigned split) const override {
        calls.push_back({parent, scramble, split});
        RixRNG::Order order = wellstrat::deriveOrder(parent, scramble, split);
        order.tag = parent.tag + 100;
        return order;
    }
};

/// Overrides the multi-sample functions as well.
class Batch : public TellTale {
public:
    mutable unsigned asked = 0;
    void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const override {
        asked += n;
        for (unsigned i = 0; i < n; ++i) xis[i] = static_cast<float>((&sc)[i].sampleid);
    }
};

/// What the interface's documentation asks of a generator, and no more.
class Minimal : public RixRNG::Generator {
public:
    float Sample1D(const SampleCtx&, unsigned) const override { return 0.25f; }
    RtFloat2 Sample2D(const SampleCtx&, unsigned) const override { return {0.25f, 0.5f}; }
    RtFloat3 Sample3D(const SampleCtx&, unsigned) const override { return {0.25f, 0.5f, 0.75f}; }
};

class GeneratorTest : public testing::Test {
protected:
    SampleCtx contexts[4] = {{11, 0}, {22, 1}, {33, 2}, {44, 3}};
    SampleCtx children[4] = {};
};

TEST_F(GeneratorTest, OnePointDrawsPassTheContextAndTheIndex) {
    const TellTale tellTale;
    RixRNG rng(contexts, 4, &tellTale);
    for (unsigned i = 0; i < 4; ++i) {
        const float expected = static_cast<float>(11 * (i + 1) + 1000 * i + 1000000 * i);
        EXPECT_EQ(rng.DrawSample1D(i), expected);
        EXPECT_EQ(rng.DrawSample2D(i), RtFloat2(expected, 2.0f));
        EXPECT_EQ(rng.DrawSample3D(i), RtFloat3(expected, 2.0f, 3.0f));
        EXPECT_EQ(rng.GenerateSample1D(i), expected);
        EXPECT_EQ(rng.GenerateSample1D(i), expected + 1000);
    }
}

TEST_F(GeneratorTest, TheDefaultMultiSampleLoopsWithTheRightIndexAndContext) {
    const TellTale tellTale;
    RixRNG rng(contexts, 4, &tellTale);
    float xi1[4];
    RtFloat2 xi2[4];
    RtFloat3 xi3[4];
    rng.DrawSamples1D(xi1);
    rng.DrawSamples2D(xi2);
    rng.DrawSamples3D(xi3);
    for (unsigned i = 0; i < 4; ++i) {
        EXPECT_EQ(xi1[i], tellTale.Sample1D(contexts[i], i));
        EXPECT_EQ(xi2[i], tellTale.Sample2D(contexts[i], i));
        EXPECT_EQ(xi3[i], tellTale.Sample3D(contexts[i], i));
    }
    rng.GenerateSamples1D(2, xi1);
    EXPECT_EQ(xi1[1], 22.0f + 1000 + 1000000);
    EXPECT_EQ(contexts[1].sampleid, 2u);
    EXPECT_EQ(contexts[2].sampleid, 2u);
}

TEST_F(GeneratorTest, AnOverriddenMultiSampleIsAskedOnceForAllPoints) {
    const Batch batch;
    RixRNG rng(contexts, 4, &batch);
    float xis[4];
    rng.GenerateSamples1D(xis);
    EXPECT_EQ(batch.asked, 4u);
    EXPECT_EQ(xis[3], 3.0f);
    rng.DrawSamples1D(3, xis);
    EXPECT_EQ(batch.asked, 7u);
    EXPECT_EQ(xis[0], 1.0f);
}

TEST_F(GeneratorTest, NoPointsAskNothing) {
    const Batch batch;
    RixRNG rng(nullptr, 0, &batch);
    rng.DrawSamples1D(nullptr);
    rng.GenerateSamples3D(nullptr);
    RixRNG child(rng, kScramble, nullptr);
    EXPECT_EQ(batch.asked, 0u);
    EXPECT_EQ(child.numPts, 0u);
    EXPECT_EQ(child.generator, &batch);
}

TEST_F(GeneratorTest, EveryKindOfChildInheritsTheGenerator) {
    const Minimal minimal;
    const RixRNG parent(contexts, 4, &minimal);
    EXPECT_EQ(RixRNG(parent, children, 2).generator, &minimal);
    EXPECT_EQ(RixRNG(&parent, children, 2).generator, &minimal);
    EXPECT_EQ(RixRNG(parent, kScramble, children).generator, &minimal);
    EXPECT_EQ(RixRNG(&parent, kScramble, children).generator, &minimal);
    EXPECT_EQ(RixRNG(parent, kScramble, children, RixRNG::Distrib{0}).generator, &minimal);
    EXPECT_EQ(RixRNG(&parent, kScramble, children, RixRNG::Distrib{0}).generator, &minimal);
    EXPECT_EQ(RixRNG(parent, kScramble, children, RixRNG::Split{4}).generator, &minimal);
    EXPECT_EQ(RixRNG(&parent, kScramble, children, RixRNG::Split{4}).generator, &minimal);
}

TEST_F(GeneratorTest, ChildOrderHearsTheParentTheScrambleAndTheSplit) {
    const TellTale tellTale;
    const unsigned indices[] = {2, 0};
    const RixRNG parent(contexts, 4, &tellTale);
    const RixRNG plain(parent, kScramble, children);
    const RixRNG split(parent, kScramble, children, RixRNG::Split{6});
    const RixRNG distrib(plain, kScramble, children, RixRNG::Distrib{9});
    const RixRNG some(parent, kScramble, indices, 2, children, RixRNG::Split{6});
    ASSERT_EQ(tellTale.calls.size(), 4u);
    EXPECT_EQ(tellTale.calls[0].split, 1u);
    EXPECT_EQ(tellTale.calls[1].split, 6u);
    EXPECT_EQ(tellTale.calls[2].split, 0u);
    EXPECT_EQ(tellTale.calls[3].split, 6u);
    for (const TellTale::Call& call : tellTale.calls) EXPECT_EQ(call.scramble, kScramble);
    EXPECT_EQ(parent.order, RixRNG::Order{});
    EXPECT_EQ(tellTale.calls[2].parent, plain.order);
    EXPECT_EQ(plain.order.tag, 100u);
    EXPECT_EQ(distrib.order.tag, 200u);
    EXPECT_EQ(some.order, split.order);
    SampleCtx copies[2];
    EXPECT_EQ(RixRNG(plain, indices, 2, copies).order, plain.order);
    EXPECT_EQ(RixRNG(plain, children, 4).order, plain.order);
    EXPECT_EQ(tellTale.calls.size(), 4u);
}

/// Tells the order that it was asked with, and derives domains of its own.
class OrderTeller : public Minimal {
public:
    mutable unsigned batches = 0;
    float OrderedSample1D(const SampleCtx& sc, unsigned, RixRNG::Order order) const override {
        return static_cast<float>(sc.patternid + 1000u * order.splits);
    }
    void MultiOrderedSample1D(unsigned n, const SampleCtx& sc, RixRNG::Order order,
                              float* xis) const override {
        ++batches;
        for (unsigned i = 0; i < n; ++i) xis[i] = OrderedSample1D((&sc)[i], i, order);
    }
    void MultiNewDomainSplit(unsigned n, const SampleCtx& parents, RixRNG::Order order, Scramble,
                             unsigned newnumsamples, SampleCtx* out) const override {
        for (unsigned i = 0; i < n; ++i) {
            const SampleCtx parent = (&parents)[i];
            out[i] = {parent.patternid + 1, parent.sampleid * newnumsamples + order.splits};
        }
    }
    void MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, RixRNG::Order, Scramble,
                               unsigned newsampleid, SampleCtx* out) const override {
        for (unsigned i = 0; i < n; ++i) out[i] = {(&parents)[i].patternid + 2, newsampleid};
    }
};

TEST_F(GeneratorTest, DrawsKnowTheOrder) {
    const OrderTeller teller;
    RixRNG split(RixRNG(contexts, 4, &teller), kScramble, children, RixRNG::Split{3});
    EXPECT_EQ(split.DrawSample1D(2), 33.0f + 1 + 3000);
    float xis[4];
    split.DrawSamples1D(xis);
    EXPECT_EQ(xis[3], 44.0f + 1 + 3000);
    EXPECT_EQ(split.GenerateSample1D(3), xis[3]);
    EXPECT_EQ(teller.batches, 1u);
}

TEST_F(GeneratorTest, AGeneratorMayDeriveDomainsOfItsOwn) {
    const OrderTeller teller;
    const RixRNG parent(contexts, 4, &teller);
    const RixRNG split(parent, kScramble, children, RixRNG::Split{3});
    EXPECT_EQ(children[2].patternid, 34u);
    EXPECT_EQ(children[2].sampleid, 2u * 3 + 1);
    SampleCtx below[4];
    split.NewDomainsSplit(kScramble, 2, below);
    for (unsigned i = 0; i < 4; ++i) {
        EXPECT_EQ(below[i].patternid, children[i].patternid + 1);
        EXPECT_EQ(below[i].sampleid, children[i].sampleid * 2 + 3);
        const SampleCtx single = split.NewDomainSplit(i, kScramble, 2);
        EXPECT_EQ(single.patternid, below[i].patternid);
        EXPECT_EQ(single.sampleid, below[i].sampleid);
        EXPECT_EQ(parent.NewDomain(i, kScramble).patternid, contexts[i].patternid + 1);
        EXPECT_EQ(parent.NewDomainDistrib(i, kScramble, 9).patternid, contexts[i].patternid + 2);
        EXPECT_EQ(parent.NewDomainDistrib(i, kScramble, 9).sampleid, 9u);
    }
    const unsigned indices[] = {3, 1};
    const RixRNG some(parent, kScramble, indices, 2, below, RixRNG::Distrib{5});
    EXPECT_EQ(below[0].patternid, contexts[3].patternid + 2);
    EXPECT_EQ(below[1].patternid, contexts[1].patternid + 2);
}

TEST_F(GeneratorTest, NullStaysNull) {
    const RixRNG parent(contexts, 4);
    EXPECT_EQ(parent.generator, nullptr);
    EXPECT_EQ(RixRNG(parent, children, 4).generator, nullptr);
    EXPECT_EQ(RixRNG(parent, kScramble, children).generator, nullptr);
    EXPECT_EQ(RixRNG(parent, kScramble, children, RixRNG::Distrib{0}).generator, nullptr);
    EXPECT_EQ(RixRNG(parent, kScramble, children, RixRNG::Split{2}).generator, nullptr);
}

TEST_F(GeneratorTest, DomainsDoNotDependOnTheGenerator) {
    const Minimal minimal;
    const RixRNG with(contexts, 4, &minimal);
    const RixRNG without(contexts, 4);
    SampleCtx others[4];
    with.NewDomainsSplit(kScramble, 3, children);
    without.NewDomainsSplit(kScramble, 3, others);
    for (unsigned i = 0; i < 4; ++i) {
        EXPECT_EQ(children[i].patternid, others[i].patternid);
        EXPECT_EQ(children[i].sampleid, others[i].sampleid);
    }
}

// One is like another: nothing is in them but what they are.
TEST(ConstantGenerators, HaveNoState) {
    const SampleCtx sc{5, 6};
    const auto expectNone = [&sc](const RixRNG::Generator& one, const RixRNG::Generator& other) {
        EXPECT_EQ(one.Sample3D(sc, 0), other.Sample3D(sc, 0));
        EXPECT_EQ(one.Sample3D(sc, 0), one.Sample3D(sc, 9));
    };
    expectNone(kJoint, wellstrat::JointProgressive());
    expectNone(kLong, wellstrat::LongProgressive());
    expectNone(kBlue, wellstrat::BlueProgressive());
    static_assert(sizeof kJoint == sizeof(RixRNG::Generator), "no members");
    static_assert(sizeof kLong == sizeof(RixRNG::Generator), "no members");
    static_assert(sizeof kBlue == sizeof(RixRNG::Generator), "no members");
}

TEST(RandomGenerator, IsHashToRandomAndRepeats) {
    const wellstrat::RandomGenerator random;
    SampleCtx sc{5, 0};
    RixRNG rng(&sc, 1, &random);
    for (unsigned s = 0; s < 1000; ++s) {
        const RtFloat3 xyz = rng.DrawSample3D(0);
        EXPECT_EQ(rng.DrawSample1D(0), HashToRandom(5, s));
        EXPECT_EQ(xyz.z, HashToRandom(5, s));
        EXPECT_EQ(rng.DrawSample2D(0), RtFloat2(xyz.x, xyz.y));
        EXPECT_TRUE(xyz.x != xyz.y && xyz.y != xyz.z);
        EXPECT_EQ(rng.GenerateSample3D(0), xyz);
    }
}

// The tables run out into the same samples, so switching is seamless.
TEST(RandomGenerator, EqualsTheTablesWhereTheyHaveRunOut) {
    const wellstrat::RandomGenerator random;
    for (unsigned s : {196608u, 1000000u, 0xffffffffu}) {
        const SampleCtx sc{77, s};
        EXPECT_EQ(random.Sample3D(sc, 0), RixProgressiveSample3D(77, s));
        EXPECT_EQ(random.Sample2D(sc, 0), RixProgressiveSample2D(77, s));
        EXPECT_EQ(random.Sample1D(sc, 0), RixProgressiveSample1D(77, s));
    }
}

} // namespace
