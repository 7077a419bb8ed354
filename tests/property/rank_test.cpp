// SPDX-License-Identifier: Apache-2.0
//
// The ranks of pixels make nets over pixels, exactly, and the tables keep them.

#include "wellstrat/rank.h"

#include "property/point_sets.h"

#include "wellstrat/bits.h"
#include "wellstrat/blue_tables.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace wellstrat::test {
namespace {

constexpr unsigned kLevels = kRankDigits / 2;

/// Coordinate `dimension` of place j in the pixel of rank r.
uint32_t coordinate(unsigned dimension, uint32_t place, uint32_t rank) {
    return sobolSample(sobolMatrix(dimension), place) ^
           reverseBits(rankTimes(rankMatrix(dimension), rank));
}

/// The places below 2^k of the pixels of the ranks below 4^a, both with constants added.
RawPoints pointsOf(unsigned k, unsigned a, std::vector<unsigned> dimensions,
                   uint32_t firstPlace = 0, uint32_t firstRank = 0) {
    return makePoints(k + 2 * a, static_cast<unsigned>(dimensions.size()),
                      [&](uint32_t i, unsigned d) {
                          const uint32_t place = firstPlace + (i & ((1u << k) - 1));
                          return coordinate(dimensions[d], place, firstRank + (i >> k));
                      });
}

TEST(Rank, MatricesAreExpansionsOfPowersOfTheInverse) {
    // (1 + z + z^2)^(l + 1) times column 2l is 1.
    for (unsigned dimension = 0; dimension < 2; ++dimension) {
        const RankMatrix matrix = rankMatrix(dimension);
        for (unsigned l = 0; l < kLevels; ++l) {
            uint32_t product = matrix.column[2 * l];
            for (unsigned power = 0; power <= l; ++power) {
                product ^= (product << 1) ^ (product << 2);
            }
            EXPECT_EQ(product, 1u) << l;
        }
    }
    EXPECT_EQ(rankMatrix(0).column[0], 0xdb6db6dbu);
    EXPECT_EQ(rankMatrix(0).column[1], 0xb6db6db6u);
    EXPECT_EQ(rankMatrix(1).column[1], 0x6db6db6du);
}

TEST(Rank, BlocksOfPixelsAreNets) {
    for (unsigned a = 0; a <= kLevels; ++a) {
        for (unsigned k = 0; k + 2 * a <= 14; ++k) {
            const NetReport report = checkNet(pointsOf(k, a, {0, 1}).set(), 0);
            EXPECT_TRUE(report.holds()) << k << ' ' << a << ' ' << report.firstViolation;
        }
    }
}

TEST(Rank, OtherRunsAndBlocksAreNets) {
    EXPECT_TRUE(checkNet(pointsOf(3, 2, {0, 1}, 5 << 3, 7 << 4).set(), 0).holds());
    EXPECT_TRUE(checkNet(pointsOf(6, 1, {0, 1}, 1 << 6, 1023 << 2).set(), 0).holds());
}

TEST(Rank, BlocksOfPixelsAreStratifiedInZ) {
    for (unsigned a = 0; a <= kLevels; ++a) {
        for (unsigned k = 0; k + 2 * a <= 18; ++k) {
            const NetReport report = checkStrata(pointsOf(k, a, {2}).set(), 0);
            EXPECT_TRUE(report.holds()) << k << ' ' << a << ' ' << report.firstViolation;
        }
    }
}

uint32_t slotRank(unsigned slot, uint32_t rank) {
    uint32_t image = 0;
    for (unsigned k = 0; k < kRankDigits; ++k) {
        if (rank >> k & 1u) image ^= kRankBank[slot][k];
    }
    return image;
}

TEST(RankBank, SlotsMapRunsToRuns) {
    for (unsigned slot = 0; slot < 16; ++slot) {
        for (unsigned a = 0; a <= kLevels; ++a) {
            std::set<uint32_t> images;
            for (uint32_t rank = 0; rank < 1u << (2 * a); ++rank) {
                images.insert(slotRank(slot, rank));
            }
            EXPECT_EQ(images.size(), std::size_t{1} << (2 * a)) << slot;
            EXPECT_EQ(*images.rbegin(), (1u << (2 * a)) - 1) << slot;
        }
    }
}

TEST(RankBank, FirstSlotIsTheIdentityAndNoTwoAreAlike) {
    std::set<std::vector<uint16_t>> different;
    for (const auto& columns : kRankBank) different.emplace(columns, columns + kRankDigits);
    EXPECT_EQ(different.size(), 16u);
    for (unsigned k = 0; k < kRankDigits; ++k) EXPECT_EQ(kRankBank[0][k], 1u << k);
}

TEST(RankTiles, AlignedBlocksHaveAlignedRuns) {
    for (const auto* tile : {&kRankTilePadded, &kRankTileSlots}) {
        for (unsigned a = 0; a <= kLevels; ++a) {
            std::set<std::pair<uint32_t, uint32_t>> runsOfBlocks;
            std::set<uint32_t> runs;
            for (uint32_t y = 0; y < kRankTileSize; ++y) {
                for (uint32_t x = 0; x < kRankTileSize; ++x) {
                    const uint32_t run = uint32_t{(*tile)[y * kRankTileSize + x]} >> (2 * a);
                    runsOfBlocks.emplace((y >> a) * kRankTileSize + (x >> a), run);
                    runs.insert(run);
                }
            }
            EXPECT_EQ(runs.size(), std::size_t{kRanks} >> (2 * a));
            EXPECT_EQ(runsOfBlocks.size(), runs.size());
        }
    }
}

} // namespace
} // namespace wellstrat::test
