// SPDX-License-Identifier: Apache-2.0
//
// The nested shuffle of the order of samples: that it is nested, and that the swaps of all nodes of
// its trees are fair and independent over pseudo-random seeds, in twos and in fours. Guards against
// orders that are shuffled alike: two domains of a pixel then stay in lockstep, and the error of
// their product stops falling.
//
// False alarms: statistics.h; the scores of one test count as two checks.

#include "statistical/environment.h"
#include "statistical/statistics.h"
#include "statistical/tree_bits.h"
#include "wellstrat/camera.h"
#include "wellstrat/lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <vector>

namespace {

using namespace statistical;
using namespace wellstrat;

constexpr unsigned kDepths = 8; // of a tree over 256 samples
constexpr unsigned kNodes = 255;

/// Groups of 256 samples, 16 to a block: neighbors, the same group in several blocks, others.
constexpr unsigned kGroups[] = {0,  1,  2,  3,  4,  5,   6,   7,   8,   12,  15,  16,
                                17, 24, 31, 32, 48, 255, 256, 272, 512, 600, 751, 767};
constexpr unsigned kGroupCount = static_cast<unsigned>(std::size(kGroups));

uint32_t sampleidOf(unsigned group, unsigned reversedIndex) {
    return group * kGroupSize + reverseByte(reversedIndex);
}

// ---- nested

// Flipping bit k of the index flips bit k of the sample looked up and none above it: runs of 2^k
// stay runs of 2^k, for every k.
TEST(Shuffle, IsNested) {
    std::mt19937 engine(1);
    for (unsigned group = 0; group < 768; ++group) {
        for (int trial = 0; trial < 8; ++trial) {
            const auto seed = static_cast<uint32_t>(engine());
            for (unsigned index = 0; index < kGroupSize; ++index) {
                const unsigned sampleid = group * kGroupSize + index;
                const uint32_t target = reverseByte(shuffledPlace(seed, sampleid));
                ASSERT_LT(shuffledPlace(seed, sampleid), kGroupSize);
                for (unsigned k = 0; k < kDepths; ++k) {
                    const uint32_t other = reverseByte(shuffledPlace(seed, sampleid ^ (1u << k)));
                    ASSERT_EQ((target ^ other) >> k, 1u)
                        << "seed " << seed << ", sampleid " << sampleid << ", bit " << k;
                }
            }
        }
    }
}

// ---- fair and independent

enum class Seeds { random, sequentialPatterns, cameraPatterns };

uint32_t patternOf(Seeds seeds, std::size_t s) {
    const auto i = static_cast<int>(s);
    return seeds == Seeds::cameraPatterns ? cameraContext(i % 512, i / 512, 3, 0).patternid
                                          : static_cast<uint32_t>(s);
}

/// The swaps of all nodes in kGroups, for many seeds. Node (depth, prefix) of a group decides
/// whether the two halves of the run of 2^(8-depth) samples that `prefix`, read from its lowest bit
/// on, leads to change places. Nodes have the numbers 2^depth + prefix, from 1 to 255.
struct Swaps {
    std::vector<uint32_t> seeds;
    BitColumns columns;

    explicit Swaps(Seeds kind)
        : seeds(std::size_t{1} << (nightly() ? 18 : 16)), columns(seeds.size()) {
        std::mt19937 engine(2);
        for (std::size_t s = 0; s < seeds.size(); ++s) {
            seeds[s] = kind == Seeds::random ? static_cast<uint32_t>(engine())
                                             : patternSeed(patternOf(kind, s));
        }
        for (const unsigned group : kGroups) addTree(group);
    }

    std::size_t column(unsigned groupIndex, std::size_t node) const {
        return columnOf_[groupIndex][node];
    }

private:
    /// The place that is looked up for a prefix and zeros after it shows the swaps along its path;
    /// those that no shorter prefix has shown are added.
    void addTree(unsigned group) {
        std::vector<std::size_t>& columnOf = columnOf_.emplace_back(kNodes + 1);
        for (unsigned prefix = 0; prefix < kGroupSize / 2; ++prefix) {
            unsigned shallowest = 0;
            while (prefix >> shallowest != 0) ++shallowest;
            for (unsigned depth = shallowest; depth < kDepths; ++depth) {
                columnOf[(1u << depth) + prefix] = columns.size() + depth - shallowest;
            }
            const uint32_t sampleid = sampleidOf(group, prefix);
            columns.add(kDepths - shallowest, [&](std::size_t s) {
                return shuffledPlace(seeds[s], sampleid) >> shallowest;
            });
        }
    }

    std::vector<std::vector<std::size_t>> columnOf_;
};

const Swaps& swapsOver(Seeds kind) {
    static std::map<Seeds, Swaps> swaps;
    return swaps.try_emplace(kind, kind).first->second;
}

class ShuffleSwaps : public testing::TestWithParam<Seeds> {
protected:
    std::size_t column(unsigned groupIndex, std::size_t node) const {
        return swaps_.column(groupIndex, node);
    }
    std::size_t randomColumn() {
        const auto group = static_cast<unsigned>(engine_() % kGroupCount);
        return column(group, engine_() % kNodes + 1);
    }
    template <typename Function>
    void forEachNode(Function function) const {
        for (unsigned g = 0; g < kGroupCount; ++g) {
            for (std::size_t node = 1; node <= kNodes; ++node) function(g, node);
        }
    }

    static void expectNoneLarge(const Scores& scores) {
        EXPECT_GE(scores.largestP(), kAlpha)
            << "largest of " << scores.count() << ": " << scores.largest();
    }
    /// For scores that are pairwise independent. Those of twos are if fours are independent; those
    /// of fours would need independent eights, which the shuffle does not have.
    static void expectStandardNormal(const Scores& scores) {
        expectNoneLarge(scores);
        EXPECT_GE(scores.meanSquareP(), kAlpha)
            << "mean square of " << scores.count() << ": " << scores.meanSquare();
    }

    const Swaps& swaps_ = swapsOver(GetParam());
    const BitColumns& columns_ = swaps_.columns;
    std::mt19937 engine_{3};
};

TEST_P(ShuffleSwaps, AreFair) {
    Scores scores;
    forEachNode([&](unsigned g, std::size_t node) { scores.add(columns_.score(column(g, node))); });
    expectStandardNormal(scores);
}

TEST_P(ShuffleSwaps, OfAGroupAreIndependentInTwos) {
    const unsigned groups = nightly() || GetParam() == Seeds::random ? kGroupCount : 4;
    Scores scores;
    for (unsigned g = 0; g < groups; ++g) {
        for (std::size_t a = 1; a <= kNodes; ++a) {
            for (std::size_t b = a + 1; b <= kNodes; ++b) {
                scores.add(columns_.score(column(g, a), column(g, b)));
            }
        }
    }
    expectStandardNormal(scores);
}

TEST_P(ShuffleSwaps, OfTheSameNodeInTwoGroupsAreIndependent) {
    Scores scores;
    forEachNode([&](unsigned g, std::size_t node) {
        for (unsigned h = 0; h < g; ++h)
            scores.add(columns_.score(column(g, node), column(h, node)));
    });
    expectStandardNormal(scores);
}

TEST_P(ShuffleSwaps, OfAnyTwoNodesAreIndependent) {
    Scores scores;
    for (int trial = 0; trial < 100000; ++trial) {
        const std::size_t a = randomColumn(), b = randomColumn();
        if (a != b) scores.add(columns_.score(a, b));
    }
    expectStandardNormal(scores);
}

TEST_P(ShuffleSwaps, OfAnyFourNodesAreIndependent) {
    Scores scores;
    for (int trial = 0; trial < 100000; ++trial) {
        std::size_t four[4];
        for (std::size_t& c : four) c = randomColumn();
        std::sort(std::begin(four), std::end(four));
        if (std::adjacent_find(std::begin(four), std::end(four)) != std::end(four)) continue;
        scores.add(columns_.score(four[0], four[1], four[2], four[3]));
    }
    expectNoneLarge(scores);
}

// Two siblings in each of two places: below two cousins, or in two groups.
TEST_P(ShuffleSwaps, OfTwoPairsOfSiblingsAreIndependent) {
    Scores scores;
    forEachNode([&](unsigned g, std::size_t node) {
        unsigned depth = 0;
        while (node >> (depth + 1) != 0) ++depth;
        if (depth == 0) return;
        const std::size_t half = std::size_t{1} << (depth - 1); // the last step of the prefix
        if (node & half) return;
        const auto pair = [&](unsigned group, std::size_t first) {
            return std::make_pair(column(group, first), column(group, first | half));
        };
        const auto here = pair(g, node);
        for (unsigned h = 0; h < g; ++h) {
            const auto there = pair(h, node);
            scores.add(columns_.score(here.first, here.second, there.first, there.second));
        }
        for (std::size_t other = std::size_t{1} << depth; other < node; ++other) {
            if (other & half) continue;
            const auto there = pair(g, other);
            scores.add(columns_.score(here.first, here.second, there.first, there.second));
        }
    });
    expectNoneLarge(scores);
}

// A node with its two children and one grandchild, and four nodes on one path: what a hash that
// mixes too few of the bits above makes dependent.
TEST_P(ShuffleSwaps, OfFamiliesAreIndependent) {
    Scores scores;
    for (unsigned g = 0; g < kGroupCount; ++g) {
        for (unsigned depth = 0; depth + 3 < kDepths; ++depth) {
            for (unsigned prefix = 0; prefix < (1u << depth); ++prefix) {
                for (unsigned steps = 0; steps < 8; ++steps) {
                    const auto below = [&](unsigned levels, unsigned path) {
                        return column(g, (1u << (depth + levels)) + (prefix | (path << depth)));
                    };
                    scores.add(columns_.score(below(0, 0), below(1, steps & 1), below(2, steps & 3),
                                              below(3, steps)));
                    if (steps < 4) {
                        scores.add(
                            columns_.score(below(0, 0), below(1, 0), below(1, 1), below(2, steps)));
                    }
                }
            }
        }
    }
    expectNoneLarge(scores);
}

// One node in four groups whose numbers (places in kGroups) close a parallelogram, by exclusive-or
// or by addition.
TEST_P(ShuffleSwaps, OfTheSameNodeInFourGroupsAreIndependent) {
    const unsigned fours[][4] = {{0, 1, 2, 3},     // 0, 1, 2, 3
                                 {0, 1, 4, 5},     // 0, 1, 4, 5
                                 {1, 2, 3, 4},     // 1, 2, 3, 4
                                 {2, 3, 6, 7},     // 2, 3, 6, 7
                                 {0, 8, 9, 4},     // 0, 8, 12, 4
                                 {0, 1, 11, 12},   // 0, 1, 16, 17
                                 {11, 15, 0, 16},  // 16, 32, 0, 48
                                 {14, 15, 17, 18}, // 31, 32, 255, 256
                                 {0, 11, 18, 19}}; // 0, 16, 256, 272
    Scores scores;
    for (const auto& f : fours) {
        for (std::size_t node = 1; node <= kNodes; ++node) {
            scores.add(columns_.score(column(f[0], node), column(f[1], node), column(f[2], node),
                                      column(f[3], node)));
        }
    }
    expectNoneLarge(scores);
}

// The order must say nothing about the values: neither the table nor the digital shifts.
TEST_P(ShuffleSwaps, AreIndependentOfTheTableAndTheShifts) {
    BitColumns columns = columns_;
    const std::size_t first = columns.size();
    for (Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
        columns.add(8, [&](std::size_t s) { return digitalShift(swaps_.seeds[s], c) >> 24; });
    }
    columns.add(7, [&](std::size_t s) { return tableOfBlock(swaps_.seeds[s], 0) / 3; });
    Scores scores;
    forEachNode([&](unsigned g, std::size_t node) {
        for (std::size_t value = first; value < columns.size(); ++value) {
            scores.add(columns.score(column(g, node), value));
        }
    });
    expectStandardNormal(scores);
}

// Pixels beside each other, and patterns one apart, have seeds one place apart.
TEST_P(ShuffleSwaps, OfNeighboringPatternsAreIndependent) {
    BitColumns columns = columns_;
    Scores scores;
    for (const unsigned g : {0u, 1u, 11u}) {
        for (unsigned prefix = 0; prefix < kGroupSize / 2; ++prefix) {
            const std::size_t next = columns.size();
            const uint32_t sampleid = sampleidOf(kGroups[g], prefix);
            columns.add(kDepths, [&](std::size_t s) {
                return shuffledPlace(swaps_.seeds[(s + 1) % columns.seeds()], sampleid);
            });
            for (unsigned depth = 0; depth < kDepths; ++depth) {
                if (prefix >> depth != 0) continue;
                scores.add(columns.score(column(g, (1u << depth) + prefix), next + depth));
            }
        }
    }
    expectStandardNormal(scores);
}

INSTANTIATE_TEST_SUITE_P(Over, ShuffleSwaps,
                         testing::Values(Seeds::random, Seeds::sequentialPatterns,
                                         Seeds::cameraPatterns),
                         [](const auto& instance) {
                             switch (instance.param) {
                             case Seeds::random: return "RandomSeeds";
                             case Seeds::sequentialPatterns: return "SequentialPatterns";
                             default: return "CameraPatterns";
                             }
                         });

} // namespace
