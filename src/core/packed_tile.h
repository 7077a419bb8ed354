// SPDX-License-Identifier: Apache-2.0
//
// Tiles of ranks (rank.h) in a sixth of their size: each aligned block of pixels has an aligned run
// of ranks, so that all there is to know is the order of the four quadrants of each block.

#pragma once

#include "wellstrat/rank.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

class PackedTile {
public:
    constexpr explicit PackedTile(const uint16_t (&tile)[kRanks]) {
        for (uint32_t place = 0; place < kRanks; ++place) {
            for (unsigned level = 0; level < kLevels; ++level) {
                const uint32_t digit = tile[place] >> 2 * (kLevels - 1 - level) & 3u;
                blocks_[block(place, level)] |=
                    static_cast<uint8_t>(digit << 2 * quadrant(place, level));
            }
        }
    }

    /// The rank at `place`.
    constexpr uint16_t operator[](uint32_t place) const {
        uint32_t rank = 0;
        for (unsigned level = 0; level < kLevels; ++level) {
            rank = rank << 2 |
                   (unsigned{blocks_[block(place, level)]} >> 2 * quadrant(place, level) & 3u);
        }
        return static_cast<uint16_t>(rank);
    }

private:
    static constexpr unsigned kLevels = kRankDigits / 2;
    static_assert(kRankTileSize == 1u << kLevels, "of the whole tile down to blocks of 2 x 2");

    /// The block of `place` among those that are 2^level in a row: after those of lower levels.
    static constexpr uint32_t block(uint32_t place, unsigned level) {
        const uint32_t x = place % kRankTileSize, y = place / kRankTileSize;
        const uint32_t before = ((1u << 2 * level) - 1) / 3;
        return before + ((y >> (kLevels - level)) << level | x >> (kLevels - level));
    }

    /// In which quadrant of it, in rows, `place` lies.
    static constexpr unsigned quadrant(uint32_t place, unsigned level) {
        const unsigned shift = kLevels - 1 - level;
        return (place / kRankTileSize >> shift & 1u) << 1 | (place >> shift & 1u);
    }

    uint8_t blocks_[(kRanks - 1) / 3] = {};
};

} // namespace detail
} // namespace stream1
} // namespace wellstrat
