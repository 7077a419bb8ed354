// SPDX-License-Identifier: Apache-2.0
//
// The search for the ranks of slots against plain sums.

#include "rank_search/rank_bank.h"

#include "rank_search/rank_banks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rank_tests {
namespace {

/// Invertible in each aligned run of 4^a ranks.
bool keepsRuns(const RankColumns& columns) {
    for (unsigned k = 0; k < kRankDigits; ++k) {
        const unsigned digit = columns[k] >> (k / 2 * 2);
        if (digit == 0 || digit > 3) return false;
        if (k % 2 == 1 && digit == static_cast<unsigned>(columns[k - 1] >> (k / 2 * 2)))
            return false;
    }
    return true;
}

TEST(RankBankSearch, BestColumnsKeepRunsAndAreBetterThanRandomOnes) {
    const Weights weights = weightsOfRandomTiles();
    RankBank bank = randomBank(3, 5);
    bank.push_back(bestColumns(bank, 3, weights));
    EXPECT_TRUE(keepsRuns(bank[3]));
    const double found = slotPrice(bank, 3, weights);
    std::mt19937 random(1);
    for (unsigned attempt = 0; attempt < 20; ++attempt) {
        bank[3] = randomColumns(random);
        EXPECT_TRUE(keepsRuns(bank[3]));
        EXPECT_LT(found, slotPrice(bank, 3, weights));
    }
}

TEST(RankBankSearch, ImprovementLowersPricesAndKeepsTheFirstSlot) {
    const Weights weights = weightsOfRandomTiles();
    RankBank bank = randomBank(3, 6);
    const double before = slotPrice(bank, 1, weights) + slotPrice(bank, 2, weights);
    unsigned searched = 0;
    improve(weights, &bank, [&] { ++searched; });
    EXPECT_EQ(searched, 2u);
    EXPECT_LT(slotPrice(bank, 1, weights) + slotPrice(bank, 2, weights), before);
    EXPECT_EQ(bank[0], identityColumns());
}

TEST(RankBankSearch, PricesAreWhatTheDefinitionSays) {
    const RankBank bank = randomBank(3, 8);
    const Weights weights = weightsOfRandomTiles();
    std::vector<Visits> visits;
    for (unsigned d = 0; d < 3; ++d) visits.push_back(visitsOf(d, bank[d]));
    const auto pair = [&](unsigned a, unsigned b) {
        return merit(weights, covarianceOf(sumsOfPairs(), visits[a], visits[b]));
    };
    const double w0 = weightForColumns(0), w2 = weightForColumns(2);
    const double pairs = (w0 * std::pow(pair(0, 1), 3) + w2 * std::pow(pair(2, 1), 3)) / (w0 + w2);
    EXPECT_NEAR(slotPrice(bank, 1, weights), pairs, 1e-9);
}

TEST(RankBankSearch, ForRandomTilesColumnsAreAlikeToFunctionsOfOneSlot) {
    const RankBank bank = randomBank(3, 4);
    const Weights weights = weightsOfRandomTiles();
    const auto meritOfSlot = [&](unsigned slot) {
        const Visits visits = visitsOf(slot, bank[slot]);
        return merit(weights, covarianceOf(sumsOfOne(), visits, visits));
    };
    EXPECT_NEAR(meritOfSlot(1), meritOfSlot(0), 1e-9);
    EXPECT_NEAR(meritOfSlot(2), meritOfSlot(0), 1e-9);
}

TEST(RankBankSearch, CovarianceOfSlotsIsTheWeightedSum) {
    const RankBank bank = randomBank(2, 9);
    const Visits a = visitsOf(0, bank[0]), b = visitsOf(1, bank[1]);
    const Covariance all = covarianceOfSlots(bank);
    const Covariance one = covarianceOf(sumsOfOne(), a, a), other = covarianceOf(sumsOfOne(), b, b);
    const Covariance pair = covarianceOf(sumsOfPairs(), a, b);
    const double wa = weightForTile(0), wb = weightForTile(1);
    EXPECT_GT(wa, wb);
    for (const std::size_t rho : {0u, 1u, 77u, 4095u}) {
        EXPECT_NEAR(all[rho], 4 * (wa * one[rho] + wb * other[rho]) / (wa + wb) + pair[rho], 1e-9);
    }
}

} // namespace
} // namespace rank_tests
