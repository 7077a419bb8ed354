// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/blue_lookup.h"

#include "core/made_table.h"
#include "core/packed_tile.h"
#include "core/slot_ranks.h"
#include "wellstrat/blue_tables.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {
namespace {

constexpr PackedTile kPadded(kRankTilePadded), kSlots(kRankTileSlots);

/// The linear map with these columns.
template <typename Word>
WELLSTRAT_MADE LinearMap<Word> makeMap(const Word (&columns)[kRankDigits]) {
    LinearMap<Word> map{};
    for (uint32_t bits = 1; bits < 64; ++bits) {
        const uint32_t others = bits & (bits - 1), first = trailingZeros(bits);
        map.of[0][bits] = map.of[0][others] ^ columns[first];
        map.of[1][bits] = map.of[1][others] ^ columns[6 + first];
    }
    return map;
}

WELLSTRAT_MADE BlueTables makeTables() {
    BlueTables tables{};
    for (unsigned place = 0; place < kRanks; ++place) {
        tables.padded[place] = kPadded[place];
        tables.padded[kRanks + place] = kPadded[transposedPlace(place)];
        tables.slots[place] = kSlots[place];
    }
    for (uint32_t bits = 0; bits < 8; ++bits) {
        const uint32_t flipped = movedPlace(0, (bits & 6u) << 17);
        tables.flips[bits] = static_cast<uint16_t>(flipped | (bits & 1u) * kRanks);
    }
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        const RankMatrix x = slotRankMatrix(0, slot), y = slotRankMatrix(1, slot);
        uint64_t xy[kRankDigits] = {};
        for (unsigned k = 0; k < kRankDigits; ++k) {
            xy[k] = x.column[k] | uint64_t{y.column[k]} << 32;
        }
        tables.xy[slot] = makeMap(xy);
        tables.z[slot] = makeMap(slotRankMatrix(2, slot).column);
    }
    return tables;
}

} // namespace

WELLSTRAT_MADE const BlueTables kBlueTables = makeTables();

} // namespace detail
} // namespace stream1
} // namespace wellstrat
