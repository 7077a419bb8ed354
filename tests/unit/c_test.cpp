// SPDX-License-Identifier: Apache-2.0
//
// The interface in C: its domains and samples are those of a RixRNG, however they were derived.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "wellstrat/blue.h"
#include "wellstrat/c.h"
#include "wellstrat/camera.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"
#include "wellstrat/version.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace wellstrat::test {
namespace {

const JointProgressive kJoint;
const LongProgressive kLong;
const BlueProgressive kBlue;
const RandomGenerator kRandom;
/// By their numbers in C; null is pmj.
const Generator* const kGenerators[] = {nullptr, &kJoint, &kLong, &kBlue, &kRandom};

template <class A, class B>
bool sameBits(const std::vector<A>& a, const std::vector<B>& b) {
    return a.size() * sizeof(A) == b.size() * sizeof(B) &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(A)) == 0;
}

/// A domain through both interfaces.
struct Twin {
    RixRNG rng;
    wellstrat_domain domain;
    std::vector<wellstrat_context> contexts;

    void expectSame() const {
        EXPECT_EQ(domain.slot, rng.order.slot);
        EXPECT_EQ(domain.splits, rng.order.splits);
        const std::vector<SampleCtx> expected(rng.sampleCtxArray, rng.sampleCtxArray + rng.numPts);
        EXPECT_TRUE(sameBits(contexts, expected));
        expectSameDraws<float>(
            1, [&](std::vector<float>& xis) { rng.DrawSamples1D(xis); }, wellstrat_draw_samples_1d,
            wellstrat_draw_sample_1d);
        expectSameDraws<RtFloat2>(
            2, [&](std::vector<RtFloat2>& xis) { rng.DrawSamples2D(xis); },
            wellstrat_draw_samples_2d, wellstrat_draw_sample_2d);
        expectSameDraws<RtFloat3>(
            3, [&](std::vector<RtFloat3>& xis) { rng.DrawSamples3D(xis); },
            wellstrat_draw_samples_3d, wellstrat_draw_sample_3d);
    }

    template <class Sample, class Expected, class Batch, class Single>
    void expectSameDraws(unsigned dims, Expected drawExpected, Batch drawBatch,
                         Single drawSingle) const {
        const std::size_t n = contexts.size();
        std::vector<Sample> expected(n);
        drawExpected(expected);
        std::vector<float> batch(dims * n), singles(dims * n);
        ASSERT_EQ(drawBatch(domain, n, contexts.data(), batch.data()), WELLSTRAT_OK);
        EXPECT_TRUE(sameBits(batch, expected)) << dims << "D";
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(drawSingle(domain, contexts[i], &singles[dims * i]), WELLSTRAT_OK);
        }
        EXPECT_TRUE(sameBits(singles, expected)) << dims << "D";
    }
};

enum class Kind { plain, split, distrib };

struct Step {
    Kind kind;
    unsigned scramble, number;
};

/// Derives in C, all at once and one by one, which must agree.
void deriveInC(Twin& twin, const Step& step) {
    const wellstrat_domain parent = twin.domain;
    const std::vector<wellstrat_context> parents = twin.contexts;
    const std::size_t n = parents.size();
    wellstrat_context* const children = twin.contexts.data(); // where the parents were
    int status = WELLSTRAT_INVALID;
    switch (step.kind) {
    case Kind::plain:
        status = wellstrat_new_domains(parent, step.scramble, n, children, &twin.domain, children);
        break;
    case Kind::split:
        status = wellstrat_new_domains_split(parent, step.scramble, step.number, n, children,
                                             &twin.domain, children);
        break;
    case Kind::distrib:
        status = wellstrat_new_domains_distrib(parent, step.scramble, step.number, n, children,
                                               &twin.domain, children);
        break;
    }
    ASSERT_EQ(status, WELLSTRAT_OK);

    for (std::size_t i = 0; i < n; ++i) {
        wellstrat_domain domain{};
        wellstrat_context context{};
        switch (step.kind) {
        case Kind::plain:
            status = wellstrat_new_domain(parent, step.scramble, parents[i], &domain, &context);
            break;
        case Kind::split:
            status = wellstrat_new_domain_split(parent, step.scramble, step.number, parents[i],
                                                &domain, &context);
            break;
        case Kind::distrib:
            status = wellstrat_new_domain_distrib(parent, step.scramble, step.number, parents[i],
                                                  &domain, &context);
            break;
        }
        ASSERT_EQ(status, WELLSTRAT_OK);
        ASSERT_EQ(std::memcmp(&domain, &twin.domain, sizeof domain), 0);
        ASSERT_EQ(std::memcmp(&context, &children[i], sizeof context), 0);
    }
}

RixRNG derivedRng(const RixRNG& parent, const Step& step, SampleCtx* contexts) {
    const Scramble scramble{step.scramble};
    switch (step.kind) {
    case Kind::plain: return {parent, scramble, contexts};
    case Kind::split: return {parent, scramble, contexts, RixRNG::Split{step.number}};
    default: return {parent, scramble, contexts, RixRNG::Distrib{step.number}};
    }
}

Step someStep(uint32_t hash) {
    constexpr unsigned kSplits[] = {1, 2, 3, 4, 16, 256, 257, 0};
    const bool slot = (hash >> 2 & 3u) != 0;
    const Kind kind = (hash & 3u) == 0   ? Kind::distrib
                      : (hash & 3u) == 1 ? Kind::split
                                         : Kind::plain;
    return {kind, slot ? wellstrat_joint_scramble(hash >> 4 & 15u) : hash, kSplits[hash >> 8 & 7u]};
}

class CGenerators : public testing::TestWithParam<unsigned> {
protected:
    const Generator* generator() const { return kGenerators[GetParam()]; }

    /// Contexts of a camera, in numbers that use vector code, its rests, and none of it.
    Twin camera(std::vector<SampleCtx>& contexts, unsigned n) const {
        contexts.clear();
        std::vector<wellstrat_context> inC;
        for (unsigned i = 0; i < n; ++i) {
            const int x = static_cast<int>(i) * 7 - 50, y = -3;
            const unsigned sampleid = i % 3 == 0 ? hashPair(5, i) : i;
            const bool isBlue = GetParam() == WELLSTRAT_BLUE;
            contexts.push_back(isBlue ? blueContext(x, y, 9, sampleid)
                                      : cameraContext(x, y, 4, sampleid, 9));
            inC.push_back(isBlue ? wellstrat_blue_context(x, y, 9, sampleid)
                                 : wellstrat_camera_context(x, y, 4, sampleid, 9));
        }
        wellstrat_domain domain{};
        EXPECT_EQ(wellstrat_camera_domain(GetParam(), &domain), WELLSTRAT_OK);
        EXPECT_EQ(domain.generator, GetParam());
        return {RixRNG(contexts.data(), n, generator()), domain, inC};
    }
};

TEST_P(CGenerators, DeriveAndDrawAsARixRngDoes) {
    for (uint32_t path = 0; path < 60; ++path) {
        std::vector<SampleCtx> contexts;
        Twin twin = camera(contexts, 1 + hashPair(path, 99) % 40);
        twin.expectSame();
        for (uint32_t depth = 0; depth < 4 && !HasFailure(); ++depth) {
            const Step step = someStep(hashPair(path, depth));
            twin.rng = derivedRng(twin.rng, step, contexts.data());
            deriveInC(twin, step);
            twin.expectSame();
        }
    }
}

TEST_P(CGenerators, AreSoundWithoutASlotWhereTheDomainIsNotKnown) {
    std::vector<SampleCtx> contexts;
    Twin twin = camera(contexts, 40);
    const Step step{Kind::split, wellstrat_joint_scramble(3), 4};
    twin.rng = derivedRng(twin.rng, step, contexts.data());
    deriveInC(twin, step);
    twin.rng = RixRNG(twin.rng, contexts.data(), 40);
    twin.domain.slot = WELLSTRAT_NO_SLOT;
    twin.expectSame();
}

TEST_P(CGenerators, DoNothingForNoPoints) {
    wellstrat_domain camera{};
    ASSERT_EQ(wellstrat_camera_domain(GetParam(), &camera), WELLSTRAT_OK);
    wellstrat_domain child{};
    ASSERT_EQ(wellstrat_new_domains_split(camera, wellstrat_joint_scramble(2), 8, 0, nullptr,
                                          &child, nullptr),
              WELLSTRAT_OK);
    EXPECT_EQ(child.generator, GetParam());
    EXPECT_EQ(child.slot, 2);
    EXPECT_EQ(child.splits, 8);
    EXPECT_EQ(wellstrat_draw_samples_1d(child, 0, nullptr, nullptr), WELLSTRAT_OK);
    EXPECT_EQ(wellstrat_draw_samples_2d(child, 0, nullptr, nullptr), WELLSTRAT_OK);
    EXPECT_EQ(wellstrat_draw_samples_3d(child, 0, nullptr, nullptr), WELLSTRAT_OK);
}

INSTANTIATE_TEST_SUITE_P(All, CGenerators, testing::Range(0u, 5u));

class CWords : public testing::TestWithParam<unsigned> {};

TEST_P(CWords, BeginWithTheBitsOfTheSample) {
    wellstrat_domain camera{}, slot{}, split{};
    ASSERT_EQ(wellstrat_camera_domain(GetParam(), &camera), WELLSTRAT_OK);
    std::vector<wellstrat_context> contexts;
    for (uint32_t i = 0; i < 500; ++i) {
        contexts.push_back({hashPair(1, i), i % 2 == 0 ? i : hashPair(2, i)});
    }
    const std::size_t n = contexts.size();
    const uint32_t scramble = wellstrat_joint_scramble(7);
    wellstrat_new_domains(camera, scramble, 0, nullptr, &slot, nullptr);
    wellstrat_new_domains_split(camera, scramble, 3, 0, nullptr, &split, nullptr);
    for (const wellstrat_domain domain : {camera, slot, split}) {
        std::vector<float> xis(3 * n), upper;
        std::vector<uint32_t> words(3 * n);
        ASSERT_EQ(wellstrat_draw_samples_3d(domain, n, contexts.data(), xis.data()), WELLSTRAT_OK);
        ASSERT_EQ(wellstrat_draw_words(domain, n, contexts.data(), words.data()), WELLSTRAT_OK);
        unsigned lowerBytes = 0;
        for (const uint32_t word : words) {
            upper.push_back(toUnitFloat(word));
            lowerBytes |= word & 0xffu;
        }
        EXPECT_TRUE(sameBits(upper, xis));
        EXPECT_EQ(lowerBytes, 0xffu);
    }
}

TEST(CWords, OfLongAreThoseOfTheSequence) {
    const wellstrat_domain domain = {WELLSTRAT_LONG, WELLSTRAT_NO_SLOT, 1};
    const wellstrat_domain slot = {WELLSTRAT_LONG, 5, 12};
    for (uint32_t i = 0; i < 200; ++i) {
        const wellstrat_context context = {hashPair(i, 0), hashPair(i, 1)};
        uint32_t words[3], slotWords[3];
        ASSERT_EQ(wellstrat_draw_words(domain, 1, &context, words), WELLSTRAT_OK);
        ASSERT_EQ(wellstrat_draw_words(slot, 1, &context, slotWords), WELLSTRAT_OK);
        for (unsigned d = 0; d < 3; ++d) {
            const auto axis = static_cast<Coordinate>(d);
            EXPECT_EQ(words[d], sequenceBits(context.patternid, context.sampleid, axis));
            EXPECT_EQ(slotWords[d],
                      jointSequenceBits(context.patternid, context.sampleid, 5, 12, axis));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Computed, CWords, testing::Values(WELLSTRAT_LONG, WELLSTRAT_BLUE));

TEST(CNumbers, AreThoseOfTheOtherHeaders) {
    EXPECT_STREQ(wellstrat_version(), WELLSTRAT_VERSION_STRING);
    EXPECT_EQ(wellstrat_stream_version(), kStreamVersion);
    EXPECT_EQ(wellstrat_joint_scramble(3), static_cast<unsigned>(jointScramble(3)));
    EXPECT_EQ(wellstrat_hash_to_unsigned(3, 4), HashToUnsigned(3, 4));
    EXPECT_EQ(wellstrat_hash_to_random(3, 4), HashToRandom(3, 4));
    EXPECT_EQ(wellstrat_build_tables(), WELLSTRAT_OK);
}

TEST(CNumbers, ChooseAndRemapAsRenderManDoes) {
    const float weights[] = {0.5f, 0.0f, -1.0f, 2.0f, 1.5f};
    for (unsigned i = 0; i < 1000; ++i) {
        const float xi = HashToRandom(i, 7), prob0 = HashToRandom(i, 8);
        float expected = xi, remapped = xi, expectedProb = 0, prob = 0;
        uint32_t chosen = 99;
        unsigned choice = RixChooseAndRemap(expected, prob0);
        ASSERT_EQ(wellstrat_choose_of_two_and_remap(prob0, &remapped, &chosen), WELLSTRAT_OK);
        EXPECT_EQ(chosen, choice);
        EXPECT_EQ(remapped, expected);

        expected = remapped = xi;
        choice = RixChooseAndRemap(expected, weights, 5, &expectedProb);
        ASSERT_EQ(wellstrat_choose_and_remap(weights, 5, &remapped, &chosen, &prob), WELLSTRAT_OK);
        EXPECT_EQ(chosen, choice);
        EXPECT_EQ(remapped, expected);
        EXPECT_EQ(prob, expectedProb);
        ASSERT_EQ(wellstrat_choose_and_remap(weights, 5, &remapped, &chosen, nullptr),
                  WELLSTRAT_OK);
    }
    float xi = 0.25f, prob = 1;
    uint32_t chosen = 99;
    ASSERT_EQ(wellstrat_choose_and_remap(nullptr, 0, &xi, &chosen, &prob), WELLSTRAT_OK);
    EXPECT_EQ(chosen, 0u);
    EXPECT_EQ(prob, 0.0f);
    EXPECT_EQ(xi, 0.25f);
}

} // namespace
} // namespace wellstrat::test
