// SPDX-License-Identifier: Apache-2.0
//
// Each slot keeps every promise of the samples without slots, and two slots are not tied to each
// other by a split.

#include "RixRNG.h"
#include "wellstrat/joint.h"

#include "property/stratified.h"
#include "statistical/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace wellstrat::test {
namespace {

#ifdef NDEBUG
constexpr unsigned kPatterns = 20;
#else
constexpr unsigned kPatterns = 1;
#endif

constexpr unsigned kBlocks = kStratifiedSamples / kTableSize;

uint32_t patternNumber(unsigned i) { return hashPair(0x6a70u, i); }

std::string blockName(uint32_t pattern, unsigned slot, unsigned split, unsigned block) {
    return "slot " + std::to_string(slot) + " split by " + std::to_string(split) + ", block " +
           std::to_string(block) + " of pattern " + std::to_string(pattern);
}

std::vector<Float3> drawBlock(uint32_t pattern, unsigned slot, unsigned split, unsigned block) {
    std::vector<SampleCtx> contexts;
    for (unsigned i = 0; i < kTableSize; ++i) contexts.push_back({pattern, block * kTableSize + i});
    std::vector<Float3> xis(kTableSize);
    drawJointSamples3D(kTableSize, contexts.data(), jointOrder(slot, split), xis.data());
    return xis;
}

class JointSlot : public testing::TestWithParam<unsigned> {};

TEST_P(JointSlot, BlocksAreStratified) {
    for (unsigned i = 0; i < kPatterns; ++i) {
        const uint32_t pattern = patternNumber(i);
        for (const unsigned block : {0u, 1 + i % (kBlocks - 2), kBlocks - 1}) {
            expectStratified(drawBlock(pattern, GetParam(), 1, block),
                             blockName(pattern, GetParam(), 1, block));
        }
    }
}

// As all branches of a visit, and the visits in order, are drawn: by sampleid. With splits above 16
// the end of the stratified visits is no multiple of 4096.
TEST_P(JointSlot, BlocksOfSplitDomainsAreStratified) {
    for (const unsigned split : {2u, 4u, 8u, 16u, 64u, 256u}) {
        for (unsigned i = 0; i < (kPatterns + 3) / 4; ++i) {
            const uint32_t pattern = patternNumber(1000 + i);
            for (const unsigned block : {0u, 1 + (7 * i + 30) % (kBlocks - 2), kBlocks - 1}) {
                expectStratified(drawBlock(pattern, GetParam(), split, block),
                                 blockName(pattern, GetParam(), split, block));
            }
        }
    }
}

TEST_P(JointSlot, BlocksAreTheDefaultsSets) {
    const auto sorted = [](std::vector<Float3> points) {
        std::sort(points.begin(), points.end(), [](const Float3& a, const Float3& b) {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        });
        return points;
    };
    for (unsigned i = 0; i < kPatterns; ++i) {
        const uint32_t pattern = patternNumber(i);
        for (const unsigned block : {0u, 1 + i, kBlocks - 1}) {
            std::vector<Float3> padded;
            for (unsigned k = 0; k < kTableSize; ++k) {
                padded.push_back(sample3D(pattern, block * kTableSize + k));
            }
            ASSERT_EQ(sorted(drawBlock(pattern, GetParam(), 1, block)), sorted(padded))
                << blockName(pattern, GetParam(), 1, block);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Slots, JointSlot, testing::Range(0u, kJointSlots));

/// Whether a sequence has visited [0, n) so far, each number once.
class Coverage {
public:
    explicit Coverage(std::size_t size) : seen_(size) {}
    void visit(uint32_t index) {
        ASSERT_LT(index, seen_.size());
        ASSERT_FALSE(seen_[index]) << index << " comes twice";
        seen_[index] = true;
        above_ = std::max(above_, index + 1);
        ++count_;
    }
    bool isWholeStart() const { return above_ == count_; }

private:
    std::vector<bool> seen_;
    uint32_t above_ = 0, count_ = 0;
};

// For any split, odd or even: the samples are all those there are, and the first 2^m visits take
// those at the start of the sequence.
TEST(JointSplit, IndicesAreAPermutationThatKeepsStarts) {
    for (unsigned split = 1; split <= kMaxJointSplit; ++split) {
        const unsigned slot = split % kJointSlots;
        const uint32_t seed = patternSeed(patternNumber(split));
        const uint32_t end = jointStratifiedSamples(split);
        Coverage coverage(end);
        for (uint32_t sampleid = 0; sampleid < end;) {
            const uint32_t visit = sampleid / split;
            if ((visit & (visit - 1)) == 0 && visit <= kTableSize) {
                ASSERT_TRUE(coverage.isWholeStart()) << visit << " visits split by " << split;
            }
            for (unsigned branch = 0; branch < split; ++branch, ++sampleid) {
                const uint32_t index =
                    detail::jointIndex(detail::kJointOrders, seed, sampleid, slot, split);
                ASSERT_NO_FATAL_FAILURE(coverage.visit(index));
                ASSERT_EQ(
                    detail::jointIndex(detail::kJointOrders, seed, visit * split, slot, split) /
                        split,
                    index / split)
                    << "the branches of a visit stand together";
            }
        }
        ASSERT_TRUE(coverage.isWholeStart());
    }
}

// Two slots under one split must pair each branch of one with each branch of the other, equally
// often. Guards against an order of branches that is the same in each visit: then branch r of one
// slot always meets branch r of the other, and a product of both domains never converges.
TEST(JointSplit, BranchesOfTwoSlotsAreNotInLockstep) {
    constexpr unsigned kVisits = 4096;
    for (const unsigned split : {2u, 3u, 4u, 5u, 6u, 8u, 12u, 16u}) {
        for (unsigned i = 0; i < 4; ++i) {
            const uint32_t seeds[2] = {patternSeed(patternNumber(i)),
                                       patternSeed(patternNumber(100 + i))};
            std::vector<uint32_t> pairs(split * split);
            for (uint32_t visit = 0; visit < kVisits; ++visit) {
                unsigned place[2];
                for (unsigned d = 0; d < 2; ++d) {
                    place[d] = detail::jointIndex(detail::kJointOrders, seeds[d], visit * split,
                                                  i + d, split) %
                               split;
                }
                ++pairs[place[0] * split + place[1]];
            }
            EXPECT_GT(statistical::uniformP(pairs), statistical::kAlpha) << "split by " << split;
        }
    }
}

// The same as an integrand sees it: the product of two slots under a split by 2, each integrand 1
// in one half of the square and -1 in the other, has the mean 0. In lockstep it would be 1 or -1.
TEST(JointSplit, ProductsOfTwoSlotsConverge) {
    constexpr unsigned kSamples = 8192;
    for (unsigned i = 0; i < 50; ++i) {
        const JointProgressive joint;
        SampleCtx camera{patternNumber(i), 0};
        int sum = 0;
        for (camera.sampleid = 0; camera.sampleid < kSamples / 2; ++camera.sampleid) {
            SampleCtx contexts[3];
            const RixRNG pixel(&camera, 1, &joint);
            const RixRNG split(pixel, static_cast<Scramble>(5), contexts, RixRNG::Split{2});
            for (unsigned branch = 0; branch < 2; ++branch, ++contexts[0].sampleid) {
                const RixRNG a(split, jointScramble(0), contexts + 1);
                const RixRNG b(split, jointScramble(1), contexts + 2);
                // x of the second of two samples is in the other half than that of the first.
                const auto sign = [](const RixRNG& rng) {
                    return rng.DrawSample2D(0).x < 0.5f ? 1 : -1;
                };
                sum += sign(a) * sign(b);
            }
        }
        // Independent signs of 4096 visits, the same in both branches: a standard deviation of
        // 2 * 64. Six of them have a false-alarm rate of 2e-9 each.
        EXPECT_LE(std::abs(sum), 6 * 2 * 64) << i;
    }
}

// Within a visit, too, two slots under one split must not know of each other: the product of a ramp
// in x of one and of the other, one visit, against the same with padding. Guards against orders of
// branches that differ by a constant, with which the error does not fall with the number of
// branches (4 times that of padding for 64). The standard error of the ratio is below 2 %.
TEST(JointSplit, BranchesOfOneVisitAreShuffled) {
    constexpr unsigned kPairs = 5000;
    for (const unsigned split : {8u, 12u, 16u, 25u, 64u, 100u, 256u}) {
        double squares[2] = {0, 0};
        for (unsigned i = 0; i < kPairs; ++i) {
            const uint32_t patterns[2] = {patternNumber(i), patternNumber(kPairs + i)};
            double sums[2] = {0, 0};
            for (unsigned branch = 0; branch < split; ++branch) {
                double products[2] = {1, 1};
                for (unsigned d = 0; d < 2; ++d) {
                    const float joint = jointSample2D(tables(), patterns[d], branch, d, split).x;
                    products[0] *= double(joint) - 0.5;
                    products[1] *= double(sample2D(patterns[d], branch).x) - 0.5;
                }
                for (unsigned k = 0; k < 2; ++k) sums[k] += products[k];
            }
            for (unsigned k = 0; k < 2; ++k) squares[k] += sums[k] * sums[k];
        }
        EXPECT_LT(std::sqrt(squares[0] / squares[1]), 1.25) << "split by " << split;
    }
}

} // namespace
} // namespace wellstrat::test
