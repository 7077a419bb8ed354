// SPDX-License-Identifier: Apache-2.0
//
// Every aligned run of computed samples is stratified, anywhere in the 2^32 of a pattern, without
// slots and in each slot, under splits by powers of two too; and slots are stratified together as
// the bank says.

#include "wellstrat/sequence_slots.h"

#include "property/stratified.h"
#include "sequence_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wellstrat::test {
namespace {

#ifdef NDEBUG
constexpr unsigned kPatterns = 8;
constexpr unsigned kLargeBlockLog2 = 16;
#else
constexpr unsigned kPatterns = 1;
constexpr unsigned kLargeBlockLog2 = 13;
#endif

uint32_t patternNumber(unsigned i) { return hashPair(0x7365u, i); }

/// bits(sampleid, coordinate) for the samples [first, first + 2^m), as a point set.
template <typename Bits>
PointSet pointsFrom(uint32_t first, unsigned m, Bits bits) {
    std::vector<uint32_t> values;
    for (uint32_t i = 0; i < (1u << m); ++i) {
        for (const Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
            values.push_back(bits(first + i, c));
        }
    }
    return PointSet::fromIntegers(values.data(), values.size() / 3, 3);
}

/// For all aligned runs in it: each coordinate alone, (x, y) and (x, y, z).
void expectStratified(const PointSet& points, const std::string& name) {
    for (unsigned d = 0; d < 3; ++d) {
        EXPECT_EQ(checkSequence(points.projection({d}), 0).firstViolation, "") << name;
    }
    EXPECT_EQ(checkSequence(points.projection({0, 1}), 0).firstViolation, "") << name;
    EXPECT_EQ(checkSequence(points, 1).firstViolation, "") << name;
    EXPECT_EQ(checkSequence(points, 0, NetBase::four).firstViolation, "") << name;
}

/// Where blocks of 2^m are looked at: the first, far beyond any table, around 2^31, the last.
std::vector<uint32_t> firstsOfBlocks(unsigned m, unsigned i) {
    const uint32_t size = 1u << m, somewhere = hashPair(3, i) & ~(size - 1);
    return {0, size, 3u << 16, (1u << 20) + size, 1u << 31, somewhere, 0u - size};
}

TEST(Sequence, BlocksAreStratified) {
    for (unsigned i = 0; i < kPatterns; ++i) {
        const uint32_t pattern = patternNumber(i);
        for (const uint32_t first : firstsOfBlocks(12, i)) {
            expectStratified(pointsFrom(first, 12,
                                        [=](uint32_t sampleid, Coordinate c) {
                                            return sequenceBits(pattern, sampleid, c);
                                        }),
                             "from " + std::to_string(first) + " on");
        }
    }
}

TEST(Sequence, LargeBlocksAreStratified) {
    for (const uint32_t first : {0u, 5u << kLargeBlockLog2, 0u - (1u << kLargeBlockLog2)}) {
        expectStratified(pointsFrom(first, kLargeBlockLog2,
                                    [](uint32_t sampleid, Coordinate c) {
                                        return sequenceBits(patternNumber(99), sampleid, c);
                                    }),
                         "from " + std::to_string(first) + " on");
    }
}

// At every level, halves of runs are halves of the indices, swapped or not with even chances; but
// for the runs from 0 on that are longer than 2^16, which are never swapped. Guards against a
// shuffle with too few levels.
TEST(Sequence, HalvesOfRunsAreSwappedAtEveryLevel) {
    constexpr unsigned kSeeds = 256;
    for (unsigned level = 0; level < 29; ++level) {
        const uint32_t half = 1u << level;
        unsigned swapped[2] = {0, 0}; // of the run from 0 on, and of one in the upper half of all
        for (unsigned i = 0; i < kSeeds; ++i) {
            const uint32_t seed = sequenceSeed(patternNumber(i));
            const uint32_t starts[2] = {0, 5u << 29};
            for (unsigned k = 0; k < 2; ++k) {
                const uint32_t a = sequenceIndex(seed, starts[k]);
                ASSERT_EQ((a ^ sequenceIndex(seed, starts[k] + half)) >> level, 1u);
                swapped[k] += a >> level & 1u;
            }
        }
        // Fair coins: a standard deviation of 8, and 7 of them have a false-alarm rate of 3e-12.
        for (unsigned k = 0; k < 2; ++k) {
            const double expected = k == 0 && level >= 16 ? 0 : kSeeds / 2.0;
            EXPECT_NEAR(swapped[k], expected, expected > 0 ? 7 * 8.0 : 0) << level;
        }
    }
}

TEST(Sequence, SamplesAreThoseOfTheDefinition) {
    for (unsigned i = 0; i < 2000; ++i) {
        const uint32_t pattern = patternNumber(i % 50), seed = sequenceSeed(pattern);
        const uint32_t sampleid = i % 3 == 0 ? i : hashPair(4, i);
        const auto bits = referencePoint(seed, referenceIndex(seed, sampleid));
        const auto unit = [](uint32_t v) { return static_cast<float>(v >> 8) * 0x1p-24f; };
        const Float3 expected{unit(bits[0]), unit(bits[1]), unit(bits[2])};
        for (unsigned c = 0; c < 3; ++c) {
            ASSERT_EQ(sequenceBits(pattern, sampleid, static_cast<Coordinate>(c)), bits[c]);
        }
        ASSERT_EQ(sequenceSample3D(pattern, sampleid), expected);
        ASSERT_EQ(sequenceSample2D(pattern, sampleid), Float2(expected.x, expected.y));
        ASSERT_EQ(sequenceSample1D(pattern, sampleid), expected.z);
    }
}

// Compilers may know samples.
static_assert(sequenceBits(1, 2, Coordinate::z) != sequenceBits(1, 3, Coordinate::z),
              "a constant expression");

// ---- slots

class SequenceSlot : public testing::TestWithParam<unsigned> {};

TEST_P(SequenceSlot, BlocksAreStratified) {
    const unsigned slot = GetParam();
    for (unsigned i = 0; i < (kPatterns + 3) / 4; ++i) {
        const uint32_t pattern = patternNumber(100 + i + slot);
        for (const unsigned split : {1u, 2u, 16u, 256u}) {
            for (const uint32_t first : firstsOfBlocks(12, i + slot)) {
                expectStratified(pointsFrom(first, 12,
                                            [=](uint32_t sampleid, Coordinate c) {
                                                return jointSequenceBits(pattern, sampleid, slot,
                                                                         split, c);
                                            }),
                                 "slot " + std::to_string(slot) + " split by " +
                                     std::to_string(split) + ", from " + std::to_string(first));
            }
        }
    }
}

// The digits of all samples of a block are those that the bank has, plus a constant of the block.
// So any two slots are together, over GF(2), what their matrices are, as far as these reach.
TEST_P(SequenceSlot, BlocksHaveTheOrderOfTheBank) {
    const unsigned slot = GetParam();
    bool seen[2] = {false, false};
    for (unsigned i = 0; i < 8; ++i) {
        const uint32_t seed = sequenceSeed(patternNumber(i));
        seen[seed >> 31] = true;
        for (const uint32_t block : {0u, 1u, 2u, 77u, (1u << (32 - kBankDigits)) - 1}) {
            const uint32_t first = block << kBankDigits;
            const PointDigits start = slotDigits(detail::kSlotOrders, seed, first, slot, 1);
            if (block == 0) {
                ASSERT_EQ(start.x | start.y | start.z, 0u);
            }
            for (uint32_t k = 0; k < (1u << kBankDigits); k += 1 + block * 5) {
                const PointDigits point = slotDigits(detail::kSlotOrders, seed, first + k, slot, 1);
                const uint32_t place = referenceSlotPlace(seed, slot, k);
                ASSERT_EQ(point.x ^ start.x, place);
                ASSERT_EQ(point.y ^ start.y, pascalTimes(place));
                ASSERT_EQ(point.z ^ start.z, trinomialTimes(place));
            }
        }
    }
    EXPECT_TRUE(seen[0] && seen[1]) << "both orders";
}

INSTANTIATE_TEST_SUITE_P(Slots, SequenceSlot, testing::Range(0u, kJointSlots));

TEST(SequenceSlots, SamplesAreThoseOfTheDefinition) {
    for (const unsigned split : {1u, 2u, 3u, 5u, 7u, 8u, 12u, 16u, 96u, 100u, 255u, 256u}) {
        const auto visits = static_cast<uint32_t>((uint64_t{1} << 32) / split);
        const uint32_t end = split & (split - 1) ? visits * split : 0; // past the last whole visit
        for (unsigned i = 0; i < 1500; ++i) {
            const uint32_t pattern = patternNumber(i % 40), seed = sequenceSeed(pattern);
            const unsigned slot = i % kJointSlots;
            const uint32_t sampleids[] = {i, hashPair(5, i) % (split << kBankDigits),
                                          hashPair(6, i), end - 1 - i, end / 2 + i - 750};
            for (const uint32_t sampleid : sampleids) {
                if (end != 0 && sampleid >= end) continue;
                const auto bits =
                    referencePoint(seed, referenceSlotIndex(seed, sampleid, slot, split));
                for (unsigned c = 0; c < 3; ++c) {
                    ASSERT_EQ(jointSequenceBits(pattern, sampleid, slot, split,
                                                static_cast<Coordinate>(c)),
                              bits[c])
                        << "slot " << slot << " split by " << split << ", sample " << sampleid;
                }
                ASSERT_EQ(jointSequenceSample3D(pattern, sampleid, slot, split),
                          Float3(toUnitFloat(bits[0]), toUnitFloat(bits[1]), toUnitFloat(bits[2])));
            }
        }
    }
}

// For any split, odd or even: no point comes twice, and the first 2^m visits take those at the
// start of the sequence, as far as the bank's blocks go.
TEST(SequenceSlots, IndicesAreAPermutationThatKeepsStarts) {
    constexpr unsigned kVisits = 1u << 11;
    for (unsigned split = 1; split <= kMaxJointSplit; ++split) {
        const unsigned slot = split % kJointSlots;
        const uint32_t seed = sequenceSeed(patternNumber(split));
        std::vector<bool> seen(std::size_t{kVisits} * split);
        uint32_t above = 0, count = 0;
        for (uint32_t sampleid = 0; sampleid < kVisits * split; ++sampleid) {
            if (sampleid % split == 0) {
                const uint32_t visit = sampleid / split;
                if ((visit & (visit - 1)) == 0) {
                    ASSERT_EQ(above, count) << visit << " visits split by " << split;
                }
            }
            const uint32_t index = slotDigits(detail::kSlotOrders, seed, sampleid, slot, split).x;
            ASSERT_LT(index, seen.size());
            ASSERT_FALSE(seen[index]) << index << " comes twice";
            seen[index] = true;
            above = std::max(above, index + 1);
            ++count;
        }
    }
}

// Where an odd split leaves some samples over at the end, these are points like any others.
TEST(SequenceSlots, SamplesBeyondTheLastWholeVisitAreInRange) {
    for (const unsigned split : {3u, 100u, 255u}) {
        for (uint32_t i = 1; i <= 300; ++i) {
            const Float3 xi = jointSequenceSample3D(i, 0u - i, i % kJointSlots, split);
            for (int d = 0; d < 3; ++d) ASSERT_TRUE(xi[d] >= 0 && xi[d] < 1);
        }
    }
}

// Beyond what the bank reaches, blocks of two slots must be paired at random: the error of a
// product of two ramps falls with the number of blocks, by the square root of 16 and not by 1. Of
// the products with x and y each, 4 blocks of 16 pairs are compared. Guards against blocks that
// follow on each other in all slots alike, whose digits of x would meet in the same way each time.
TEST(SequenceSlots, BlocksOfTwoSlotsAreNotInLockstep) {
    constexpr unsigned kBlocks = 16, kPairs = 24, kTaken = 1u << 10;
    for (const Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
        double ofOne = 0, ofAll = 0;
        for (unsigned pair = 0; pair < kPairs; ++pair) {
            const uint32_t a = patternNumber(2 * pair), b = patternNumber(2 * pair + 1);
            double all = 0;
            for (uint32_t block = 0; block < kBlocks; ++block) {
                double sum = 0;
                for (uint32_t k = 0; k < kTaken; ++k) {
                    const uint32_t sampleid = (block << kBankDigits) + k;
                    sum += (jointSequenceBits(a, sampleid, 1, 1, c) * 0x1p-32 - 0.5) *
                           (jointSequenceBits(b, sampleid, 2, 1, c) * 0x1p-32 - 0.5);
                }
                ofOne += sum * sum / kBlocks;
                all += sum;
            }
            ofAll += all * all / kBlocks;
        }
        // Both have the same expectation; in lockstep, `ofAll` would be 16 times the other.
        EXPECT_LT(ofAll, 4 * ofOne);
    }
}

} // namespace
} // namespace wellstrat::test
