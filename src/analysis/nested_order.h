// SPDX-License-Identifier: Apache-2.0
//
// What chance does to two streams whose orders are nested shuffles of each other.
//
// A nested shuffle (Owen 1995) halves the indices again and again, and swaps the halves of each
// part or not, by a fair coin of its own. Two streams are independent if one can be shuffled so and
// nothing is changed in what is likely. That is so for random points, which have no order, and for
// nets whose orders were scrambled by such shuffles. Two things follow exactly:
//
//     Functions of the index fall into parts, one for each level of the halving (Haar's wavelets).
//     The products of two functions' parts of different levels have the mean 0 whatever the
//     functions are, and so have those of one level, with the variance |f|^2 |g|^2 / dims, where
//     dims is the number of wavelets of the level.
//
//     Where each block of `side` points visits each of `side` rows once, in the order of the first
//     block but for nested shuffles, and the same is so of columns, each block fills the grid with
//     one point a row and column. At each level, a block that has come to a pair of halves, of
//     rows and columns, keeps or swaps what is in them: one coin. So the counts are those of coins,
//     (side^2 - 1) / 3 numbers of heads, each given how many blocks have come to it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The part of a function of the index that one level has.
struct OrderLevel {
    double energy; ///< the sum of its squares
    double dims;   ///< how many wavelets there are
};

/// The levels of a function of the index, whose sum is 0, from pairs of neighbors to halves of the
/// largest parts of a power of two points. What is left, the means of an odd number of such parts,
/// is the last level.
std::vector<OrderLevel> orderLevels(std::vector<double> values);

/// The variance of the sum of products of two functions, with the same number of points, of which
/// one is in a nested shuffle of its order.
double productVariance(const std::vector<OrderLevel>& a, const std::vector<OrderLevel>& b);

/// For each point its place in a block of `side` points with the order of the first block, if each
/// block visits each cell once and is a nested shuffle of the first; else nothing. Cells are less
/// than `side`.
std::vector<uint32_t> nestedPlaces(const std::vector<uint32_t>& cells, unsigned side);

/// Counts of places of one stream against places of another, against the coins that made them.
struct CoinCounts {
    double chiSquare = 0;      ///< the sum of (heads - tails)^2 / coins
    double degrees = 0;        ///< how many numbers of heads there are: the mean of chiSquare
    double logProbability = 0; ///< the logarithm of the probability of exactly these counts
};

/// Of `side` * `side` counts, row by row; `side` is a power of two.
CoinCounts coinCounts(std::vector<uint32_t> counts, std::size_t side);

} // namespace stream1
} // namespace wellstrat
