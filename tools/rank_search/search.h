// SPDX-License-Identifier: Apache-2.0
//
// The tables of wellstrat/blue_tables.h: a tile for padded domains, the ranks of slots, and a tile
// for all of these.

#pragma once

#include "rank_search/rank_bank.h"

#include <functional>

namespace wellstrat::ranks {

struct SearchOptions {
    uint32_t seed = 2;
    unsigned sweeps = 800; ///< of each annealing
    unsigned rounds = 3;   ///< of improvement of the slots' ranks
    std::size_t slots = 16;
};

struct RankTables {
    RankBank bank;
    Tile padded, slots;
};

/// The same for the same options on every machine and with any number of threads. Calls `progress`,
/// from any thread but one at a time, with the part that is done, in [0, 1].
RankTables searchRanks(const SearchOptions& options, const std::function<void(double)>& progress);

} // namespace wellstrat::ranks
