// SPDX-License-Identifier: Apache-2.0

#include "batch/blue_ranks.h"

#include "core/slot_ranks.h"
#include "wellstrat/blue_lookup.h"

namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace {

template <unsigned kBits>
struct SlotMaps {
    RankMap<kBits> of[kJointSlots][3];
};

template <unsigned kBits>
constexpr SlotMaps<kBits> makeMaps() {
    SlotMaps<kBits> maps{};
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        for (unsigned dimension = 0; dimension < 3; ++dimension) {
            const RankMatrix matrix = detail::slotRankMatrix(dimension, slot);
            for (unsigned k = 0; k < kRankDigits; ++k) {
                for (unsigned bits = 0; bits < 1u << kBits; ++bits) {
                    if ((bits >> k % kBits & 1u) == 0) continue;
                    maps.of[slot][dimension].parts[k / kBits][bits] ^= matrix.column[k];
                }
            }
        }
    }
    return maps;
}

static_assert(sizeof(detail::BlueTables) + sizeof(SlotMaps<3>) + sizeof(SlotMaps<4>) <= 64 * 1024,
              "all that is made for BlueProgressive is small enough for any cache");

} // namespace

template <unsigned kBits>
const RankMap<kBits>* rankMaps(unsigned slot) {
    static constexpr SlotMaps<kBits> kMaps = makeMaps<kBits>();
    return kMaps.of[slot];
}
template const RankMap<3>* rankMaps<3>(unsigned slot);
template const RankMap<4>* rankMaps<4>(unsigned slot);

void findRanks(std::size_t n, const uint16_t* tile, uint32_t* places) {
    for (std::size_t i = 0; i < n; ++i) places[i] = tile[places[i]];
}

void findDigitsXY(std::size_t n, const uint16_t* tile, unsigned slot, const uint32_t* places,
                  uint64_t* xy) {
    const detail::LinearMap<uint64_t>& map = detail::kBlueTables.xy[slot];
    for (std::size_t i = 0; i < n; ++i) xy[i] = map(tile[places[i]]);
}

void findDigitsZ(std::size_t n, const uint16_t* tile, unsigned slot, const uint32_t* places,
                 uint32_t* z) {
    const detail::LinearMap<uint32_t>& map = detail::kBlueTables.z[slot];
    for (std::size_t i = 0; i < n; ++i) z[i] = map(tile[places[i]]);
}

} // namespace batch
} // namespace stream1
} // namespace wellstrat
