// SPDX-License-Identifier: Apache-2.0
//
// How good the ranks of the library are, exactly, for the orders of slots that it has.

#include "rank_search/judge.h"

#include "wellstrat/blue_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace rank_tests {
namespace {

using namespace wellstrat;
using namespace wellstrat::ranks;

RankTables tablesOf(std::size_t slots) {
    RankTables tables{RankBank(slots),
                      {std::begin(kRankTilePadded), std::end(kRankTilePadded)},
                      {std::begin(kRankTileSlots), std::end(kRankTileSlots)}};
    for (std::size_t d = 0; d < slots; ++d) {
        std::copy_n(kRankBank[d], kRankDigits, tables.bank[d].begin());
    }
    return tables;
}

/// The geometric mean over models of what is left with 2^k samples a pixel.
double meanRatio(const std::vector<Judgement>& rows, const std::string& what,
                 const std::set<std::string>& models, unsigned k) {
    double sum = 0;
    for (const Judgement& row : rows) {
        if (row.what == what && row.statistic == "mean" && models.count(row.model) != 0) {
            sum += std::log(row.ratios[k]);
        }
    }
    return std::exp(sum / static_cast<double>(models.size()));
}

TEST(RanksOfTheLibrary, LeaveLittleOfTheError) {
    const std::set<std::string> ofXY{"smooth", "edge", "box"};
    const std::set<std::string> ofX{"smooth of x", "step of x"}, ofZ{"smooth of z", "step of z"};
    const std::set<std::string> ofPairs{"smooth x smooth", "edge x edge", "box x box",
                                        "edge across"};
    const std::vector<Judgement> rows = judge(tablesOf(2));
    const double most[] = {0.70, 0.69, 0.67, 0.64, 0.58, 0.50, 0.45}; // of pairs
    for (unsigned k = 0; k <= kRunDigits; ++k) {
        EXPECT_LE(meanRatio(rows, "padded", ofXY, k), 0.41) << k;
        EXPECT_LE(meanRatio(rows, "padded", ofX, k), 0.31) << k;
        EXPECT_LE(meanRatio(rows, "padded", ofZ, k), 0.32) << k;
        EXPECT_LE(meanRatio(rows, "slot", ofXY, k), 0.45) << k;
        EXPECT_LE(meanRatio(rows, "slot", ofX, k), 0.38) << k;
        EXPECT_LE(meanRatio(rows, "slot", ofZ, k), 0.40) << k;
        EXPECT_LE(meanRatio(rows, "pair", ofPairs, k), most[k]) << k;
    }
}

TEST(RanksOfTheLibrary, NoPairOfSlotsIsWorseThanPadding) {
    const RankTables tables = tablesOf(16);
    const Weights weights = weightsOf(tables.slots);
    for (unsigned a = 0; a < 16; ++a) {
        for (unsigned b = 0; b < a; ++b) {
            const Covariance covariance = covarianceOf(sumsOfPairs(), visitsOf(a, tables.bank[a]),
                                                       visitsOf(b, tables.bank[b]));
            EXPECT_LE(std::sqrt(merit(weights, covariance)), 1.05) << a << ' ' << b;
        }
    }
}

} // namespace
} // namespace rank_tests
