// SPDX-License-Identifier: Apache-2.0
//
// The hash of the computed sequence (sequence.h), as a scrambling of coordinates and as a shuffle:
// that the flips of single nodes of its trees are fair, that any two are independent, in one tree,
// in the trees of two coordinates and of two patterns, and that the flips along the paths of two
// points are, on which alone the variance of an integral depends. And that no digit is weak.
//
// False alarms: statistics.h; the scores of one test count as two checks.

#include "statistical/environment.h"
#include "statistical/statistics.h"
#include "statistical/tree_bits.h"
#include "wellstrat/camera.h"
#include "wellstrat/sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace {

using namespace statistical;
using namespace wellstrat;

// ---- nested

// Flipping digit k flips digit k of the result and no digit before it.
TEST(OwenHash, IsNested) {
    std::mt19937 engine(1);
    for (int trial = 0; trial < 20000; ++trial) {
        const auto key = static_cast<uint32_t>(engine()), digits = static_cast<uint32_t>(engine());
        const uint32_t scrambled = owenHash(digits, key);
        for (unsigned k = 0; k < 32; ++k) {
            const uint32_t changed = owenHash(digits ^ (1u << k), key) ^ scrambled;
            ASSERT_EQ(changed & (0xffffffffu >> (31 - k)), 1u << k)
                << "digits " << digits << ", key " << key << ", digit " << k;
        }
    }
}

// ---- fair and independent

enum class Seeds { random, sequentialPatterns, cameraPatterns };

uint32_t patternOf(Seeds seeds, std::size_t s) {
    const auto i = static_cast<int>(s);
    switch (seeds) {
    case Seeds::random: return hashPair(1, static_cast<uint32_t>(s));
    case Seeds::cameraPatterns: return cameraContext(i % 512, i / 512, 3, 0).patternid;
    default: return static_cast<uint32_t>(s);
    }
}

enum class Tree { x, y, z, shuffle };
constexpr Tree kTrees[] = {Tree::x, Tree::y, Tree::z, Tree::shuffle};

uint32_t keyOf(Tree tree, uint32_t seed) {
    return tree == Tree::shuffle ? shuffleKey(seed)
                                 : scramblingKey(seed, static_cast<Coordinate>(tree));
}

/// The flip of digit `depth` after the digits `prefix`.
struct Node {
    Tree tree;
    unsigned depth;
    uint32_t prefix;
};
bool operator==(const Node& a, const Node& b) {
    return a.tree == b.tree && a.depth == b.depth && a.prefix == b.prefix;
}

/// The flips of many nodes, for many patterns: in each tree the first seven digits whole, which
/// matter most to coordinates; the last eight after zeros and after others, which are those of the
/// first indices in the shuffle; and others at random.
class Flips {
public:
    explicit Flips(Seeds kind)
        : seeds_(std::size_t{1} << (nightly() ? 18 : 16)), columns_(seeds_.size()) {
        for (std::size_t s = 0; s < seeds_.size(); ++s) {
            seeds_[s] = sequenceSeed(patternOf(kind, s));
        }
        std::mt19937 engine(2);
        for (const Tree tree : kTrees) {
            for (unsigned depth = 0; depth < 7; ++depth) {
                for (uint32_t p = 0; p < (1u << depth); ++p) add({tree, depth, p});
            }
            for (const uint32_t group : {0u, 1u, 17u}) {
                for (unsigned depth = 24; depth < 32; ++depth) {
                    for (uint32_t p = 0; p < (1u << (depth - 24)); p += 1 + group % 2) {
                        add({tree, depth, p << 24 | reverseBits(group << 8)});
                    }
                }
            }
            for (unsigned depth = 5; depth < 32; ++depth) {
                for (int k = 0; k < 6; ++k) {
                    const auto digits = static_cast<uint32_t>(engine());
                    add({tree, depth, digits & ((1u << depth) - 1) & (k < 3 ? 63u : ~0u)});
                }
            }
        }
    }

    const std::vector<uint32_t>& seeds() const { return seeds_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    const BitColumns& columns() const { return columns_; }

    static uint32_t flip(const Node& node, uint32_t seed) {
        return (owenHash(node.prefix, keyOf(node.tree, seed)) ^ node.prefix) >> node.depth & 1u;
    }

private:
    void add(const Node& node) {
        for (const Node& other : nodes_) {
            if (other == node) return;
        }
        nodes_.push_back(node);
        columns_.add(1, [&](std::size_t s) { return flip(node, seeds_[s]); });
    }

    std::vector<uint32_t> seeds_;
    std::vector<Node> nodes_;
    BitColumns columns_;
};

const Flips& flipsOver(Seeds kind) {
    static std::map<Seeds, Flips> flips;
    return flips.try_emplace(kind, kind).first->second;
}

class SequenceFlips : public testing::TestWithParam<Seeds> {
protected:
    const Flips& flips_ = flipsOver(GetParam());
    const std::vector<Node>& nodes_ = flips_.nodes();
    const BitColumns& columns_ = flips_.columns();

    /// Patterns that count up are spread more evenly than random ones, and so are some of their
    /// flips: pairs of one tree's first digits have a mean square of 0.89 over 2^18 patterns. Only
    /// more than 1, which comes of flips that are biased or tied, is a fault there.
    void expectStandardNormal(const Scores& scores) const {
        EXPECT_GE(scores.largestP(), kAlpha)
            << "largest of " << scores.count() << ": " << scores.largest();
        if (GetParam() != Seeds::random && scores.meanSquare() < 1) return;
        EXPECT_GE(scores.meanSquareP(), kAlpha)
            << "mean square of " << scores.count() << ": " << scores.meanSquare();
    }
};

TEST_P(SequenceFlips, AreFair) {
    Scores scores;
    for (std::size_t a = 0; a < nodes_.size(); ++a) scores.add(columns_.score(a));
    expectStandardNormal(scores);
}

TEST_P(SequenceFlips, OfFirstDigitsAreIndependentInTwos) {
    for (const Tree tree : kTrees) {
        Scores scores;
        for (std::size_t a = 0; a < nodes_.size(); ++a) {
            if (nodes_[a].tree != tree || nodes_[a].depth >= 7) continue;
            for (std::size_t b = 0; b < a; ++b) {
                if (nodes_[b].tree == tree && nodes_[b].depth < 7) scores.add(columns_.score(a, b));
            }
        }
        expectStandardNormal(scores);
    }
}

// Of one tree or of two.
TEST_P(SequenceFlips, OfAnyTwoNodesAreIndependent) {
    std::mt19937 engine(3);
    Scores scores;
    for (int trial = 0; trial < 200000; ++trial) {
        const std::size_t a = engine() % nodes_.size(), b = engine() % nodes_.size();
        if (a != b) scores.add(columns_.score(a, b));
    }
    expectStandardNormal(scores);
}

// Those of the first digits of all coordinates and of the shuffle, with each other. Guards against
// keys that share their lowest bits, as all products of one seed do.
TEST_P(SequenceFlips, OfFirstDigitsAreIndependentOfOtherTrees) {
    Scores scores;
    for (std::size_t a = 0; a < nodes_.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (nodes_[a].tree != nodes_[b].tree && nodes_[a].depth < 4 && nodes_[b].depth < 4) {
                scores.add(columns_.score(a, b));
            }
        }
    }
    expectStandardNormal(scores);
}

TEST_P(SequenceFlips, OfNeighboringPatternsAreIndependent) {
    Scores scores;
    const std::vector<uint32_t>& seeds = flips_.seeds();
    for (std::size_t a = 0; a < nodes_.size(); a += 3) {
        BitColumns both(seeds.size());
        both.add(1, [&](std::size_t s) { return Flips::flip(nodes_[a], seeds[s]); });
        both.add(1, [&](std::size_t s) {
            return Flips::flip(nodes_[a], seeds[(s + 1) % seeds.size()]);
        });
        scores.add(both.score(std::size_t{0}, std::size_t{1}));
    }
    expectStandardNormal(scores);
}

// Two points of a pattern differ from some digit on in x, and from some other one on in y. What the
// hash makes of all later digits of both must be independent, each with each: any exclusive-or of
// flips along the four paths is fair.
TEST_P(SequenceFlips, AlongThePathsOfTwoPointsAreIndependent) {
    constexpr uint32_t kMask = 31; // of the first five digits
    std::mt19937 engine(4);
    const auto digits = [&] { return static_cast<uint32_t>(engine()) & kMask; };
    const std::vector<uint32_t>& seeds = flips_.seeds();
    const int trials = nightly() ? 20000 : 2000;
    const std::size_t used = seeds.size() / 4;
    Scores scores;
    for (int trial = 0; trial < trials; ++trial) {
        uint32_t points[2][2], chosen[2][2];
        bool none = true;
        for (unsigned c = 0; c < 2; ++c) {
            for (unsigned k = 0; k < 2; ++k) {
                points[c][k] = digits();
                chosen[c][k] = digits() & (trial % 2 == 0 ? digits() : kMask);
            }
            // Up to where the two differ they share the nodes; those of the first count.
            const uint32_t differing = points[c][0] ^ points[c][1];
            const uint32_t shared = differing == 0 ? kMask : (differing & (0 - differing)) * 2 - 1;
            chosen[c][1] &= ~shared;
            none = none && (chosen[c][0] | chosen[c][1]) == 0;
        }
        if (none) continue;
        uint32_t ones = 0;
        for (std::size_t s = 0; s < used; ++s) {
            uint32_t sum = 0;
            for (unsigned c = 0; c < 2; ++c) {
                const uint32_t key = scramblingKey(seeds[s], static_cast<Coordinate>(c));
                for (unsigned k = 0; k < 2; ++k) {
                    sum ^= (owenHash(points[c][k], key) ^ points[c][k]) & chosen[c][k];
                    sum ^= sum >> 16; // keeps the parity
                    sum ^= sum >> 8;
                    sum ^= sum >> 4;
                    sum = (0x6996u >> (sum & 15u)) & 1u;
                }
            }
            ones += sum;
        }
        const auto n = static_cast<double>(used);
        scores.add((2 * ones - n) / std::sqrt(n));
    }
    EXPECT_GE(scores.largestP(), kAlpha)
        << "largest of " << scores.count() << ": " << scores.largest();
}

INSTANTIATE_TEST_SUITE_P(Over, SequenceFlips,
                         testing::Values(Seeds::random, Seeds::sequentialPatterns,
                                         Seeds::cameraPatterns),
                         [](const auto& instance) {
                             switch (instance.param) {
                             case Seeds::random: return "RandomPatterns";
                             case Seeds::sequentialPatterns: return "SequentialPatterns";
                             default: return "CameraPatterns";
                             }
                         });

// ---- digits

// Each byte of a word, over patterns at some sampleids. Guards against weak last digits, which lie
// below all strata and come from the hash alone: one that leaves some values out, or prefers some.
TEST(SequenceDigits, AreUniformInEachByte) {
    constexpr unsigned kPatterns = 1u << 17;
    for (const uint32_t sampleid : {0u, 1u, 255u, 65536u, 0x12345678u}) {
        for (const Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
            std::vector<uint32_t> counts[4];
            for (auto& count : counts) count.resize(256);
            for (uint32_t pattern = 0; pattern < kPatterns; ++pattern) {
                const uint32_t bits = sequenceBits(pattern, sampleid, c);
                for (unsigned byte = 0; byte < 4; ++byte) ++counts[byte][bits >> 8 * byte & 255u];
            }
            for (unsigned byte = 0; byte < 4; ++byte) {
                EXPECT_GE(uniformP(counts[byte]), kAlpha)
                    << "byte " << byte << " of coordinate " << static_cast<int>(c) << " of sample "
                    << sampleid;
            }
        }
    }
}

// The last two bytes of the samples of one pattern. Under exact scrambling they are independent, so
// that the statistics of patterns are chi-square each; their sum over all patterns is too, and so
// is the largest. Guards against a hash whose last digits are uniform over patterns only.
TEST(SequenceDigits, AreUniformInEachPattern) {
    constexpr unsigned kSamples = 1u << 12, kPatterns = 100;
    for (const unsigned byte : {0u, 1u}) {
        double sum = 0;
        for (uint32_t pattern = 0; pattern < kPatterns; ++pattern) {
            for (const Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
                std::vector<uint32_t> counts(256);
                for (uint32_t i = 0; i < kSamples; ++i) {
                    ++counts[sequenceBits(pattern, i, c) >> 8 * byte & 255u];
                }
                double squares = 0;
                for (const uint32_t count : counts) {
                    ASSERT_GT(count, 0u) << "a value that pattern " << pattern << " leaves out";
                    squares += (count - 16.0) * (count - 16.0) / 16.0;
                }
                EXPECT_GE(chiSquareTail(squares, 255), kAlpha) << "pattern " << pattern;
                sum += squares;
            }
        }
        EXPECT_GE(twoSided(chiSquareTail(sum, 255 * 3.0 * kPatterns)), kAlpha)
            << "byte " << byte << ": " << sum / (255 * 3.0 * kPatterns);
    }
}

} // namespace
