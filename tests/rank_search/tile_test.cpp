// SPDX-License-Identifier: Apache-2.0
//
// Tiles, their weights and their annealing.

#include "rank_search/tile.h"

#include "rank_search/rank_banks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace rank_tests {
namespace {

constexpr unsigned kSize = kRankTileSize;

bool isNested(const Tile& tile) {
    for (unsigned a = 0; a <= kRankDigits / 2; ++a) {
        std::set<std::pair<unsigned, unsigned>> runsOfBlocks;
        std::set<unsigned> runs;
        for (unsigned pixel = 0; pixel < kRanks; ++pixel) {
            const unsigned block = (pixel / kSize >> a) * kSize + (pixel % kSize >> a);
            runsOfBlocks.emplace(block, tile[pixel] >> (2 * a));
            runs.insert(tile[pixel] >> (2 * a));
        }
        if (runs.size() != kRanks >> (2 * a) || runsOfBlocks.size() != runs.size()) return false;
    }
    return true;
}

Covariance covarianceOfPadded() {
    const Visits visits = visitsOf(0, identityColumns());
    return covarianceOf(sumsOfOne(), visits, visits);
}

TEST(RankTile, WeightsAreThoseOfAllPairs) {
    std::mt19937 random(1);
    const Tile tile = randomTile(random);
    Weights plain(kRanks);
    const auto distance = [](unsigned a, unsigned b) {
        return std::min((a - b) % kSize, (b - a) % kSize);
    };
    for (unsigned p = 0; p < kRanks; ++p) {
        for (unsigned q = 0; q < kRanks; ++q) {
            const unsigned dx = distance(p % kSize, q % kSize), dy = distance(p / kSize, q / kSize);
            if (dx > 8 || dy > 8) continue;
            const double squared = dx * dx + dy * dy;
            plain[tile[p] ^ tile[q]] +=
                (0.8 * std::exp(-squared / 16) + 0.2 * std::exp(-squared / 4)) / kRanks;
        }
    }
    const Weights weights = weightsOf(tile);
    for (unsigned rho = 0; rho < kRanks; ++rho) EXPECT_NEAR(weights[rho], plain[rho], 1e-6) << rho;
}

TEST(RankTile, MeanWeightsAreThoseOfManyRandomTiles) {
    std::mt19937 random(1);
    constexpr unsigned kTiles = 100;
    double sum = 0;
    const Covariance covariance = covarianceOfPadded();
    for (unsigned i = 0; i < kTiles; ++i) {
        sum += merit(weightsOf(randomTile(random)), covariance) / kTiles;
    }
    EXPECT_NEAR(sum / merit(weightsOfRandomTiles(), covariance), 1, 0.005);
}

TEST(RankTile, AnnealingKeepsBlocksAndLowersTheMerit) {
    std::mt19937 random(1);
    const Covariance covariance = covarianceOfPadded();
    const Tile plain = randomTile(random);
    EXPECT_TRUE(isNested(plain));
    double last = merit(weightsOf(plain), covariance);
    for (const unsigned sweeps : {1u, 8u, 40u}) {
        unsigned swept = 0;
        const Tile tile = annealedTile(covariance, sweeps, random, [&] { ++swept; });
        EXPECT_EQ(swept, sweeps);
        EXPECT_TRUE(isNested(tile));
        const double now = merit(weightsOf(tile), covariance);
        EXPECT_LT(now, last);
        last = now;
    }
    EXPECT_LT(last, 0.84 * merit(weightsOfRandomTiles(), covariance));
}

} // namespace
} // namespace rank_tests
