// SPDX-License-Identifier: Apache-2.0
//
// The theorem of docs/blue.md: every aligned run of 2^k samples of all pixels of an aligned block
// of 2^a x 2^a is a (0, k + 2a, 2)-net in (x, y), in padded domains and in all slots.

#include "blue_tile.h"

#include "wellstrat/analysis/nets.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/blue_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace wellstrat::test {
namespace {

#ifdef NDEBUG
constexpr unsigned kBlocks = 6;
#else
constexpr unsigned kBlocks = 1;
#endif

constexpr auto kHit = static_cast<Scramble>(0x03707344u);
constexpr auto kLight = static_cast<Scramble>(0xa4093822u);

/// All runs of 2^k samples, k + 2a <= 12, of 4096 points: 2^(12 - 2a) samples of one block.
void expectNets(const std::vector<Float3>& xis, unsigned a, const std::string& name) {
    const PointSet points = PointSet::fromFloats(&xis[0].x, xis.size(), 3);
    const PointSet xy = points.projection({0, 1});
    for (std::size_t size = std::size_t{1} << 2 * a; size <= points.count(); size *= 2) {
        for (std::size_t first = 0; first < points.count(); first += size) {
            ASSERT_EQ(checkNet(xy.block(first, size), 0).firstViolation, "")
                << name << ", points " << first << " to " << first + size;
            ASSERT_EQ(checkStrata(points.block(first, size), 2).firstViolation, "")
                << name << ", z of points " << first << " to " << first + size;
        }
    }
}

/// For each a, some blocks and some 4096 points of each, of sampleids of all sizes.
void expectNets(const BlueTile& tile, const std::string& name) {
    for (unsigned a = 0; a <= 6; ++a) {
        const unsigned side = 64 >> a, run = 4096 >> 2 * a;
        for (unsigned i = 0; i < kBlocks; ++i) {
            const uint32_t random = hashPair(a, i + tile.state() * kBlocks);
            const unsigned x = random % side, y = (random >> 6) % side;
            const uint32_t run0 = i == 0 ? 0 : (random >> 12) >> (i % 20);
            const std::string block = name + ", block (" + std::to_string(x) + ", " +
                                      std::to_string(y) + ") of side 2^" + std::to_string(a) +
                                      ", sample " + std::to_string(run0 * run);
            ASSERT_NO_FATAL_FAILURE(expectNets(tile.draw(a, x, y, run0 * run, run), a, block));
        }
    }
}

TEST(BlueNets, PaddedDomains) {
    const Steps domains[] = {{},
                             {{kLight, 1}},
                             {{kHit, 1}, {kLight, 1}},
                             {{kHit, 4}, {kLight, 1}},
                             {{kHit, 1}, {kLight, 3}},
                             {{kHit, 1}, {kLight, 0}},
                             {{jointScramble(3), 1}, {kLight, 1}}};
    int column = -2;
    for (const Steps& steps : domains) {
        for (const unsigned seed : {0u, 7u}) {
            const BlueTile tile(++column, 5, seed, steps);
            ASSERT_TRUE(tile.isPadded());
            ASSERT_NO_FATAL_FAILURE(expectNets(tile, "padded " + std::to_string(column)));
        }
    }
}

class BlueSlots : public testing::TestWithParam<unsigned> {};

TEST_P(BlueSlots, Nets) {
    const Scramble slot = jointScramble(GetParam());
    const Steps domains[] = {{{slot, 1}},
                             {{kHit, 1}, {slot, 1}},
                             {{kHit, 4}, {slot, 1}},
                             {{slot, 16}},
                             {{kHit, 256}, {slot, 1}}};
    int row = static_cast<int>(GetParam()) - 8;
    for (const Steps& steps : domains) {
        const BlueTile tile(-3, ++row, GetParam(), steps);
        ASSERT_FALSE(tile.isPadded());
        ASSERT_NO_FATAL_FAILURE(expectNets(tile, "slot " + std::to_string(GetParam())));
    }
}

INSTANTIATE_TEST_SUITE_P(All, BlueSlots, testing::Range(0u, kJointSlots));

/// Whether the first digits of x and the first of y, `all` in sum, of the points of samples of
/// `runLog2` bits and ranks of `rankBits` determine both, for all ways to share them out: the
/// generator matrices then have full rank, which is the net property of all runs and blocks,
/// wherever they begin.
template <typename Digits>
bool isNet(unsigned runLog2, unsigned rankBits, Digits digits) {
    const unsigned all = runLog2 + rankBits;
    for (unsigned ofX = 0; ofX <= all; ++ofX) {
        std::vector<uint64_t> basis;
        for (unsigned b = 0; b < all; ++b) {
            const PointDigits p = b < runLog2 ? digits(1u << b, 0) : digits(0, 1u << (b - runLog2));
            uint64_t row = (p.x & ((uint64_t{1} << ofX) - 1)) |
                           (p.y & ((uint64_t{1} << (all - ofX)) - 1)) << 32;
            for (const uint64_t other : basis) row = std::min(row, row ^ other);
            if (row == 0) return false;
            basis.push_back(row);
        }
    }
    return true;
}

/// The same for the strata of z.
template <typename Digits>
bool fillsStrataOfZ(unsigned runLog2, unsigned rankBits, Digits digits) {
    const unsigned all = runLog2 + rankBits;
    std::vector<uint64_t> basis;
    for (unsigned b = 0; b < all; ++b) {
        const PointDigits p = b < runLog2 ? digits(1u << b, 0) : digits(0, 1u << (b - runLog2));
        uint64_t row = p.z & ((uint64_t{1} << all) - 1);
        for (const uint64_t other : basis) row = std::min(row, row ^ other);
        if (row == 0) return false;
        basis.push_back(row);
    }
    return true;
}

// What the draws above check for some runs and blocks, for all of them. (Before scrambling, which
// keeps nets, and which the draws above went through.)
TEST(BlueNets, HoldForAllRunsAndBlocks) {
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        const auto digits = [&](uint32_t index, uint32_t rank) {
            return detail::movedDigits(slotDigits(detail::kSlotOrders, 0, index, slot, 1),
                                       detail::rankDigits(detail::kBlueTables, slot, rank), 0);
        };
        for (unsigned a = 0; a <= 6; ++a) {
            for (unsigned k = 0; k <= 12; ++k) {
                EXPECT_TRUE(isNet(k, 2 * a, digits)) << "slot " << slot << " " << k << " " << a;
                EXPECT_TRUE(fillsStrataOfZ(k, 2 * a, digits)) << slot << " " << k << " " << a;
            }
        }
    }
}

// In padded domains for runs of any length, since they have no blocks of 4096.
TEST(BlueNets, PaddedHoldForLongRuns) {
    const auto digits = [&](uint32_t index, uint32_t rank) {
        return detail::movedDigits(sequenceDigits(index),
                                   detail::rankDigits(detail::kBlueTables, 0, rank), 0);
    };
    for (unsigned a = 0; a <= 6; ++a) {
        for (unsigned k = 0; k + 2 * a <= 32; ++k) {
            EXPECT_TRUE(isNet(k, 2 * a, digits)) << k << " " << a;
            EXPECT_TRUE(k > 12 || fillsStrataOfZ(k, 2 * a, digits)) << k << " " << a;
        }
    }
}

TEST(BlueDigits, AreThoseOfTheRank) {
    for (uint32_t rank = 0; rank < kRanks; ++rank) {
        const PointDigits digits = detail::rankDigits(detail::kBlueTables, 0, rank);
        ASSERT_EQ(digits.x, rankTimes(rankMatrix(0), rank)) << rank;
        ASSERT_EQ(digits.y, rankTimes(rankMatrix(1), rank)) << rank;
        ASSERT_EQ(digits.z, rankTimes(rankMatrix(2), rank)) << rank;
        const PointDigits exchanged = detail::movedDigits({1, 2, 3}, digits, 0x80000000u);
        ASSERT_EQ(exchanged.x, 2u ^ digits.y) << rank;
        ASSERT_EQ(exchanged.y, 1u ^ digits.x) << rank;
        ASSERT_EQ(exchanged.z, 3u ^ digits.z) << rank;
    }
}

// Both tiles number the pixels of every aligned block of 2^a x 2^a by an aligned run of ranks.
TEST(BlueTiles, AreQuadtrees) {
    for (const uint16_t* tile : {kRankTilePadded, kRankTileSlots}) {
        std::vector<bool> seen(kRanks);
        for (unsigned place = 0; place < kRanks; ++place) {
            ASSERT_LT(tile[place], kRanks);
            ASSERT_FALSE(seen[tile[place]]) << "rank " << tile[place] << " comes twice";
            seen[tile[place]] = true;
            for (unsigned a = 1; a <= 6; ++a) {
                const unsigned low = (1u << a) - 1;
                const unsigned corner = place & ~(low | low << 6);
                ASSERT_EQ(tile[place] >> 2 * a, tile[corner] >> 2 * a) << place << " " << a;
            }
        }
    }
    for (unsigned place = 0; place < kRanks; ++place) {
        EXPECT_EQ(detail::kBlueTables.slots[place], kRankTileSlots[place]);
        const uint32_t hash = HashToUnsigned(place, 1);
        EXPECT_EQ(detail::kBlueTables.padded[detail::paddedPlace(detail::kBlueTables, place, hash)],
                  kRankTilePadded[detail::movedPlace(place, hash)]);
    }
}

} // namespace
} // namespace wellstrat::test
