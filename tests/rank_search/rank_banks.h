// SPDX-License-Identifier: Apache-2.0
//
// Ranks of slots to test with.

#pragma once

#include "rank_search/rank_bank.h"

#include <cstdint>
#include <random>

namespace rank_tests {

using namespace wellstrat;
using namespace wellstrat::ranks;

/// Columns that are as random as they may be.
inline RankColumns randomColumns(std::mt19937& random) {
    RankColumns columns{};
    for (unsigned level = 0; level < kRankDigits / 2; ++level) {
        const unsigned first = 1 + static_cast<unsigned>(random()) % 3;
        const unsigned second = 1 + (first + static_cast<unsigned>(random()) % 2) % 3;
        for (unsigned bit = 0; bit < 2; ++bit) {
            const unsigned below = static_cast<unsigned>(random()) & ((1u << (2 * level)) - 1);
            columns[2 * level + bit] =
                static_cast<uint16_t>((bit == 0 ? first : second) << (2 * level) | below);
        }
    }
    return columns;
}

inline RankBank randomBank(std::size_t slots, uint32_t seed) {
    std::mt19937 random(seed);
    RankBank bank{identityColumns()};
    while (bank.size() < slots) bank.push_back(randomColumns(random));
    return bank;
}

} // namespace rank_tests
