// SPDX-License-Identifier: Apache-2.0
//
// The ranks of slots: matrices V_d, without which two slots of a pixel would be in lockstep.
//
// A beam search, column after column. All candidates for column k
// are judged at once, since what a candidate c adds to the merit is a convolution: the sum over n <
// kRun and t < 2^k of F(U n, (V t) XOR c) times what the other slots have at n and t + 2^k.

#pragma once

#include "rank_search/tile.h"

#include <functional>
#include <vector>

namespace wellstrat::ranks {

/// V_d by the columns of each slot d. Bits 2l and 2l + 1 of a rank are one digit of the quadtree,
/// so columns 2l and 2l + 1 have no bits but the lowest 2l + 2, and those at 2l and 2l + 1 make an
/// invertible block: aligned runs of 4^a ranks are mapped to aligned runs.
using RankBank = std::vector<RankColumns>;

/// What slots count, lower ones more; the weight of a pair is the product.
double weightForColumns(std::size_t slot);
double weightForTile(std::size_t slot);

/// The covariance of all functions of one and of two slots, weighted, for a tile.
Covariance covarianceOfSlots(const RankBank& bank);

/// What is sought to be low: the cubes of the merits of the slot and each of the others, weighted.
/// A cube makes a bad pair dear. (Functions of one slot do not take part: for random tiles, all
/// columns are alike to them.)
double slotPrice(const RankBank& bank, std::size_t slot, const Weights& weights);

/// The columns of slot `slot` with the lowest price that the search finds, beside all others of the
/// bank, which need not have it yet.
RankColumns bestColumns(const RankBank& bank, std::size_t slot, const Weights& weights);

/// Looks for better columns for each slot but the first. Calls `searched` after each.
void improve(const Weights& weights, RankBank* bank, const std::function<void()>& searched);

} // namespace wellstrat::ranks
