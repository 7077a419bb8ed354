// SPDX-License-Identifier: Apache-2.0
//
// Every batch target that this processor has gives the bits of the scalar functions, for every
// length and so every remainder, any alignment, in place, and for contexts of all kinds in one
// batch.

#include "RixRNG.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/joint.h"
#include "wellstrat/sequence_slots.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace wellstrat {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

/// Longer than the largest block, eight vectors of 16, and one vector.
constexpr std::size_t kLongest = 150;

template <typename T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

std::vector<std::string> targets() {
    std::vector<std::string> names;
    for (unsigned i = 0; batchTarget(i) != nullptr; ++i) names.emplace_back(batchTarget(i));
    return names;
}

/// What contexts of a batch look like.
enum class Kind { coherent, tiles, mixedBlocks, atTheEnd, someBeyond, allBeyond, anything };

SampleCtx makeContext(Kind kind, unsigned i) {
    const unsigned pattern = HashToUnsigned(11, i);
    const unsigned random = HashToUnsigned(12, i);
    switch (kind) {
    case Kind::coherent: return {pattern, 37};
    case Kind::tiles: return {HashToUnsigned(11, i / 40) << 12 | (i & 63u), 5 + i / 60};
    case Kind::mixedBlocks: return {pattern, random % kStratifiedSamples};
    case Kind::atTheEnd: return {pattern, kStratifiedSamples - random % 2};
    case Kind::someBeyond: return {pattern, random % (2 * kStratifiedSamples)};
    case Kind::allBeyond: return {pattern, kStratifiedSamples + random % 1000};
    default: return {pattern, random};
    }
}

class BatchTarget : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override { ASSERT_TRUE(forceBatchTarget(GetParam().c_str())); }
    void TearDown() override { forceBatchTarget(batchTarget(0)); }

    /// Calls check(contexts) for batches of every length and kind; a guard context follows the
    /// last, and the first is at any offset to the alignment of vectors.
    template <typename Check>
    void forBatches(Check check) {
        for (const Kind kind : {Kind::coherent, Kind::tiles, Kind::mixedBlocks, Kind::atTheEnd,
                                Kind::someBeyond, Kind::allBeyond, Kind::anything}) {
            for (std::size_t n = 0; n <= kLongest; ++n) {
                std::vector<SampleCtx> contexts(n);
                for (std::size_t i = 0; i < n; ++i) {
                    contexts[i] = makeContext(kind, static_cast<unsigned>(n * 100 + i));
                }
                check(contexts);
            }
        }
    }

    /// The results of a batch function: n of them, and a guard that must stay.
    template <typename T, typename Fill>
    static std::vector<T> guarded(std::size_t n, Fill fill) {
        std::vector<T> results(n + 1);
        std::memset(static_cast<void*>(&results[n]), 0x5a, sizeof(T));
        const T guard = results[n];
        fill(results.data());
        EXPECT_TRUE(sameBits(results[n], guard)) << "wrote beyond the end of " << n;
        results.pop_back();
        return results;
    }

    template <typename Sample, typename Draw, typename Generate, typename Scalar>
    void checkDraws(Draw draw, Generate generate, Scalar scalar) {
        forBatches([&](const std::vector<SampleCtx>& contexts) {
            const std::size_t n = contexts.size();
            const auto drawn =
                guarded<Sample>(n, [&](Sample* xis) { draw(n, contexts.data(), xis); });
            std::vector<SampleCtx> stepped = contexts;
            const auto generated =
                guarded<Sample>(n, [&](Sample* xis) { generate(n, stepped.data(), xis); });
            for (std::size_t i = 0; i < n; ++i) {
                const SampleCtx sc = contexts[i];
                const Sample expected = scalar(sc.patternid, sc.sampleid);
                ASSERT_TRUE(sameBits(drawn[i], expected)) << i << " of " << n;
                ASSERT_TRUE(sameBits(generated[i], expected)) << i << " of " << n;
                ASSERT_TRUE(sameBits(stepped[i], SampleCtx{sc.patternid, sc.sampleid + 1}));
            }
        });
    }

    /// Runs across all that changes: vectors, groups, blocks, the end of the tables, and 2^32.
    template <typename Sample, typename Draw, typename Scalar>
    static void checkRuns(Draw draw, Scalar scalar) {
        for (const uint32_t first : {0u, 200u, kTableSize - 70, 5 * kTableSize - 3,
                                     kStratifiedSamples - 65, kStratifiedSamples + 9, 0u - 40}) {
            for (std::size_t n = 0; n <= kLongest; ++n) {
                const uint32_t pattern = HashToUnsigned(first, static_cast<unsigned>(n));
                const auto drawn =
                    guarded<Sample>(n, [&](Sample* xis) { draw(n, pattern, first, xis); });
                for (std::size_t i = 0; i < n; ++i) {
                    const auto sampleid = static_cast<uint32_t>(first + i);
                    ASSERT_TRUE(sameBits(drawn[i], Sample{scalar(pattern, sampleid)}))
                        << i << " of " << n << " from " << first;
                }
            }
        }
    }

    /// One batch of a function that takes an order.
    template <typename Sample, typename Draw, typename Scalar>
    static void checkOrdered(const std::vector<SampleCtx>& contexts, Draw draw, Order order,
                             Scalar scalar) {
        const std::size_t n = contexts.size();
        const auto drawn =
            guarded<Sample>(n, [&](Sample* xis) { draw(n, contexts.data(), order, xis); });
        for (std::size_t i = 0; i < n; ++i) {
            const SampleCtx sc = contexts[i];
            ASSERT_TRUE(sameBits(drawn[i], scalar(sc.patternid, sc.sampleid)))
                << i << " of " << n << ", slot " << order.slot << " split by " << order.splits;
        }
    }

    template <typename Sample, typename Draw, typename Scalar = Sample (*)(uint32_t, uint32_t)>
    void checkPaddedDraws(Draw draw, Scalar scalar) {
        forBatches([&](const std::vector<SampleCtx>& contexts) {
            checkOrdered<Sample>(contexts, draw, Order{}, scalar);
        });
    }

    /// With splits of all kinds: odd, powers of 2, both, and the largest.
    template <typename Sample, typename Draw,
              typename Scalar = Sample (*)(uint32_t, uint32_t, unsigned, unsigned)>
    void checkJointDraws(Draw draw, Scalar scalar) {
        unsigned slot = 0;
        for (const unsigned split : {1u, 2u, 3u, 8u, 12u, 100u, 255u, 256u}) {
            forBatches([&](const std::vector<SampleCtx>& contexts) {
                slot = (slot + 1) % kJointSlots;
                checkOrdered<Sample>(
                    contexts, draw, jointOrder(slot, split),
                    [=](unsigned p, unsigned s) { return scalar(p, s, slot, split); });
            });
        }
    }

    template <typename Batch, typename Scalar>
    void checkDomains(Batch batch, Scalar scalar) {
        forBatches([&](const std::vector<SampleCtx>& parents) {
            const std::size_t n = parents.size();
            const auto children = guarded<SampleCtx>(
                n, [&](SampleCtx* results) { batch(n, parents.data(), results); });
            std::vector<SampleCtx> inPlace = parents;
            batch(n, inPlace.data(), inPlace.data());
            for (std::size_t i = 0; i < n; ++i) {
                ASSERT_TRUE(sameBits(children[i], scalar(parents[i]))) << i << " of " << n;
                ASSERT_TRUE(sameBits(inPlace[i], children[i])) << i << " of " << n;
            }
        });
    }
};

TEST_P(BatchTarget, Draws1D) {
    checkDraws<float>(drawSamples1D, generateSamples1D,
                      [](unsigned p, unsigned s) { return sample1D(p, s); });
}

TEST_P(BatchTarget, Draws2D) {
    checkDraws<Float2>(drawSamples2D, generateSamples2D,
                       [](unsigned p, unsigned s) { return sample2D(p, s); });
}

TEST_P(BatchTarget, Draws3D) {
    checkDraws<Float3>(drawSamples3D, generateSamples3D,
                       [](unsigned p, unsigned s) { return sample3D(p, s); });
}

TEST_P(BatchTarget, Runs) {
    checkRuns<float>(drawRun1D, [](unsigned p, unsigned s) { return sample1D(p, s); });
    checkRuns<Float2>(drawRun2D, [](unsigned p, unsigned s) { return sample2D(p, s); });
    checkRuns<Float3>(drawRun3D, [](unsigned p, unsigned s) { return sample3D(p, s); });
}

TEST_P(BatchTarget, JointDraws1D) {
    checkJointDraws<float>(drawJointSamples1D,
                           [](auto... sample) { return jointSample1D(tables(), sample...); });
}

TEST_P(BatchTarget, JointDraws2D) {
    checkJointDraws<Float2>(drawJointSamples2D,
                            [](auto... sample) { return jointSample2D(tables(), sample...); });
}

TEST_P(BatchTarget, JointDraws3D) {
    checkJointDraws<Float3>(drawJointSamples3D,
                            [](auto... sample) { return jointSample3D(tables(), sample...); });
}

TEST_P(BatchTarget, SequenceDraws1D) {
    checkPaddedDraws<float>(drawSequenceSamples1D, sequenceSample1D);
    checkJointDraws<float>(drawSequenceSamples1D, jointSequenceSample1D);
}

TEST_P(BatchTarget, SequenceDraws2D) {
    checkPaddedDraws<Float2>(drawSequenceSamples2D, sequenceSample2D);
    checkJointDraws<Float2>(drawSequenceSamples2D, jointSequenceSample2D);
}

TEST_P(BatchTarget, SequenceDraws3D) {
    checkPaddedDraws<Float3>(drawSequenceSamples3D, sequenceSample3D);
    checkJointDraws<Float3>(drawSequenceSamples3D, jointSequenceSample3D);
}

/// All bits of a sample, by those of its coordinates: bits(coordinate).
template <typename Bits, typename OfCoordinate>
Bits allBits(OfCoordinate bits) {
    if constexpr (std::is_same_v<Bits, uint32_t>) {
        return bits(Coordinate::z);
    } else if constexpr (std::is_same_v<Bits, Bits2>) {
        return {bits(Coordinate::x), bits(Coordinate::y)};
    } else {
        return {bits(Coordinate::x), bits(Coordinate::y), bits(Coordinate::z)};
    }
}

template <typename Bits>
Bits bitsOfSequence(unsigned p, unsigned s) {
    return allBits<Bits>([=](Coordinate c) { return sequenceBits(p, s, c); });
}
template <typename Bits>
Bits bitsOfSlot(unsigned p, unsigned s, unsigned slot, unsigned split) {
    return allBits<Bits>([=](Coordinate c) { return jointSequenceBits(p, s, slot, split, c); });
}

TEST_P(BatchTarget, SequenceBits1D) {
    checkPaddedDraws<uint32_t>(drawSequenceBits1D, bitsOfSequence<uint32_t>);
    checkJointDraws<uint32_t>(drawSequenceBits1D, bitsOfSlot<uint32_t>);
}

TEST_P(BatchTarget, SequenceBits2D) {
    checkPaddedDraws<Bits2>(drawSequenceBits2D, bitsOfSequence<Bits2>);
    checkJointDraws<Bits2>(drawSequenceBits2D, bitsOfSlot<Bits2>);
}

TEST_P(BatchTarget, SequenceBits3D) {
    checkPaddedDraws<Bits3>(drawSequenceBits3D, bitsOfSequence<Bits3>);
    checkJointDraws<Bits3>(drawSequenceBits3D, bitsOfSlot<Bits3>);
}

// Every sampleid for which vector code divides, by every split: it divides in floats, which must be
// exact. Then those around the ends.
TEST_P(BatchTarget, JointDrawsAreSplitExactly) {
    constexpr unsigned kEnd = kStratifiedSamples + 2 * kMaxJointSplit;
    std::vector<SampleCtx> contexts;
    for (unsigned s = 0; s < kEnd; ++s) contexts.push_back({s, s});
    for (unsigned s = 0; s < 64; ++s) contexts.push_back({s, 0u - s});
    for (unsigned s = 0; s < 64; ++s) contexts.push_back({s, 0x80000020u - s});
    std::vector<float> xis(contexts.size());
    for (unsigned split = 1; split <= kMaxJointSplit; ++split) {
        const unsigned slot = split % kJointSlots;
        drawJointSamples1D(contexts.size(), contexts.data(), jointOrder(slot, split), xis.data());
        for (std::size_t i = 0; i < contexts.size(); ++i) {
            const SampleCtx sc = contexts[i];
            ASSERT_EQ(xis[i], jointSample1D(tables(), sc.patternid, sc.sampleid, slot, split))
                << "sample " << sc.sampleid << " split by " << split;
        }
    }
}

TEST_P(BatchTarget, BlueDraws1D) {
    checkPaddedDraws<float>(drawBlueSamples1D, blueSample1D);
    checkJointDraws<float>(drawBlueSamples1D, blueSlotSample1D);
}

TEST_P(BatchTarget, BlueDraws2D) {
    checkPaddedDraws<Float2>(drawBlueSamples2D, blueSample2D);
    checkJointDraws<Float2>(drawBlueSamples2D, blueSlotSample2D);
}

TEST_P(BatchTarget, BlueDraws3D) {
    checkPaddedDraws<Float3>(drawBlueSamples3D, blueSample3D);
    checkJointDraws<Float3>(drawBlueSamples3D, blueSlotSample3D);
}

TEST_P(BatchTarget, NewDomains) {
    checkDomains([](std::size_t n, const SampleCtx* parents,
                    SampleCtx* children) { newDomains(n, parents, kScramble, children); },
                 [](SampleCtx sc) { return sc.NewDomain(kScramble); });
}

TEST_P(BatchTarget, NewDomainsSplit) {
    for (const unsigned count : {0u, 1u, 4u, 0x10001u}) {
        checkDomains(
            [=](std::size_t n, const SampleCtx* parents, SampleCtx* children) {
                newDomainsSplit(n, parents, kScramble, count, children);
            },
            [=](SampleCtx sc) { return sc.NewDomainSplit(kScramble, count); });
    }
}

TEST_P(BatchTarget, NewDomainsDistrib) {
    for (const unsigned first : {0u, 123u}) {
        checkDomains(
            [=](std::size_t n, const SampleCtx* parents, SampleCtx* children) {
                newDomainsDistrib(n, parents, kScramble, first, children);
            },
            [=](SampleCtx sc) { return sc.NewDomainDistrib(kScramble, first); });
    }
}

TEST_P(BatchTarget, NewBlueDomains) {
    for (const unsigned count : {0u, 1u, 4u, 0x10001u}) {
        checkDomains(
            [=](std::size_t n, const SampleCtx* parents, SampleCtx* children) {
                newBlueDomainsSplit(n, parents, kScramble, count, children);
            },
            [=](SampleCtx sc) { return newBlueDomainSplit(sc, kScramble, count); });
        checkDomains(
            [=](std::size_t n, const SampleCtx* parents, SampleCtx* children) {
                newBlueDomainsDistrib(n, parents, kScramble, count, children);
            },
            [=](SampleCtx sc) { return newBlueDomainDistrib(sc, kScramble, count); });
    }
}

TEST_P(BatchTarget, HashToRandom) {
    forBatches([&](const std::vector<SampleCtx>& contexts) {
        const std::size_t n = contexts.size();
        const auto xis =
            guarded<float>(n, [&](float* results) { hashToRandom(n, contexts.data(), results); });
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_EQ(xis[i], HashToRandom(contexts[i].patternid, contexts[i].sampleid));
        }
    });
}

/// A misaligned start: results and contexts one element into their arrays.
TEST_P(BatchTarget, AnyAlignment) {
    std::vector<SampleCtx> contexts(kLongest + 1);
    for (unsigned i = 0; i <= kLongest; ++i) contexts[i] = makeContext(Kind::someBeyond, i);
    std::vector<Float3> xis(kLongest + 1);
    drawSamples3D(kLongest, contexts.data() + 1, xis.data() + 1);
    for (std::size_t i = 1; i <= kLongest; ++i) {
        ASSERT_TRUE(sameBits(xis[i], sample3D(contexts[i].patternid, contexts[i].sampleid)));
    }
}

/// The bits of a point of blue_lookup.h.
template <typename Bits>
Bits bitsOfPoint(const detail::BluePoint& point) {
    return allBits<Bits>(
        [&](Coordinate c) { return scrambledBits(digitsOf(point.digits, c), point.seed, c); });
}
template <typename Bits>
Bits bitsOfBlue(unsigned p, unsigned s) {
    return bitsOfPoint<Bits>(detail::bluePoint(detail::kBlueTables, p, s));
}
template <typename Bits>
Bits bitsOfBlueSlot(unsigned p, unsigned s, unsigned slot, unsigned split) {
    return bitsOfPoint<Bits>(
        detail::blueSlotPoint(detail::kBlueTables, detail::kSlotOrders, p, s, slot, split));
}

TEST_P(BatchTarget, BlueBits) {
    checkPaddedDraws<uint32_t>(drawBlueBits1D, bitsOfBlue<uint32_t>);
    checkJointDraws<uint32_t>(drawBlueBits1D, bitsOfBlueSlot<uint32_t>);
    checkPaddedDraws<Bits2>(drawBlueBits2D, bitsOfBlue<Bits2>);
    checkJointDraws<Bits2>(drawBlueBits2D, bitsOfBlueSlot<Bits2>);
    checkPaddedDraws<Bits3>(drawBlueBits3D, bitsOfBlue<Bits3>);
    checkJointDraws<Bits3>(drawBlueBits3D, bitsOfBlueSlot<Bits3>);
}

INSTANTIATE_TEST_SUITE_P(Targets, BatchTarget, testing::ValuesIn(targets()),
                         [](const auto& target) { return target.param; });

TEST(BatchTargets, TheLastIsScalarAndUnknownOnesAreRefused) {
    const std::vector<std::string> names = targets();
    ASSERT_FALSE(names.empty());
    EXPECT_EQ(names.back(), "scalar");
    const std::string before = chosenBatchTarget();
    EXPECT_FALSE(forceBatchTarget("no such target"));
    EXPECT_EQ(chosenBatchTarget(), before);
}

TEST(Batch, NothingIsReadOrWrittenForZeroPoints) {
    drawSamples1D(0, nullptr, nullptr);
    generateSamples3D(0, nullptr, nullptr);
    drawJointSamples2D(0, nullptr, jointOrder(0), nullptr);
    drawSequenceSamples1D(0, nullptr, {}, nullptr);
    drawBlueSamples2D(0, nullptr, jointOrder(0, 3), nullptr);
    drawBlueBits3D(0, nullptr, {}, nullptr);
    drawSequenceBits2D(0, nullptr, jointOrder(0), nullptr);
    newBlueDomainsDistrib(0, nullptr, kScramble, 0, nullptr);
    drawSequenceSamples3D(0, nullptr, jointOrder(0, 3), nullptr);
    newDomainsDistrib(0, nullptr, kScramble, 0, nullptr);
    hashToRandom(0, nullptr, nullptr);
    EXPECT_STREQ(chosenBatchTarget(), batchTarget(0));
}

} // namespace
} // namespace wellstrat
