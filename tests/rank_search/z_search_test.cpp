// SPDX-License-Identifier: Apache-2.0
#include "rank_search/z_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace rank_tests {
namespace {

using namespace wellstrat;
using namespace wellstrat::ranks;

TEST(RankZ, StratifiesIsExact) {
    EXPECT_TRUE(stratifiesZ(rankMatrix(0))); // x is stratified by itself too, and so is y
    EXPECT_FALSE(stratifiesZ(RankMatrix{}));
    RankMatrix matrix = rankMatrix(2);
    EXPECT_TRUE(stratifiesZ(matrix));
    // Rows 20 and 21 of the first two columns alike.
    for (unsigned k = 0; k < 2; ++k) {
        matrix.column[k] &= ~(1u << 21);
        matrix.column[k] |= (matrix.column[k] >> 20 & 1u) << 21;
    }
    EXPECT_FALSE(stratifiesZ(matrix));
}

TEST(RankZ, SearchFindsOneThatStratifiesAndIsBetterThanOthers) {
    const RankMatrix found = searchZ(3, 20);
    EXPECT_TRUE(stratifiesZ(found));
    const Weights weights = weightsOfRandomTiles();
    std::mt19937 random(3);
    for (unsigned i = 0; i < 20; ++i) {
        const RankMatrix other = randomZ(random);
        EXPECT_TRUE(stratifiesZ(other));
        EXPECT_LE(meritOfZ(found, weights), meritOfZ(other, weights));
    }
}

TEST(RankZ, OfTheLibraryIsWhatTheSearchFinds) {
    const RankMatrix found = searchZ(), own = rankMatrix(2);
    EXPECT_TRUE(std::equal(std::begin(found.column), std::end(found.column), own.column));
}

} // namespace
} // namespace rank_tests
