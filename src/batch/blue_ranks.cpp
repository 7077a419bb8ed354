// SPDX-License-Identifier: Apache-2.0

#include "batch/blue_ranks.h"

#include "wellstrat/blue_lookup.h"

namespace wellstrat {
inline namespace stream1 {
namespace batch {

void paddedRanks(std::size_t n, uint32_t* places) {
    for (std::size_t i = 0; i < n; ++i) places[i] = detail::kBlueTables.padded[places[i]];
}

void slotRanks(std::size_t n, unsigned slot, uint32_t* places) {
    const detail::LinearMap& words = detail::kBlueTables.rank[slot];
    for (std::size_t i = 0; i < n; ++i) places[i] = words(detail::kBlueTables.slots[places[i]]);
}

void rankDigitsZ(std::size_t n, const uint32_t* ranks, uint32_t* digits) {
    for (std::size_t i = 0; i < n; ++i) digits[i] = detail::kBlueTables.z(ranks[i] >> 4);
}

} // namespace batch
} // namespace stream1
} // namespace wellstrat
