// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/sequence_slots.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {
namespace {

/// The bits of a visit that its order changes: those below the highest one in which it differs from
/// the number of visits, so that the largest aligned run of whole visits that it is in is kept.
uint32_t slotOrderMask(uint32_t visit, uint32_t visits) {
    uint32_t differing = visit ^ visits;
    for (unsigned shift = 1; shift < 32; shift *= 2) differing |= differing >> shift;
    return differing / 2;
}

} // namespace

uint32_t laterSlotBlock(uint32_t seed, uint32_t sampleid) {
    const uint32_t block = sampleid & ~((1u << kSlotDigits) - 1u);
    const uint32_t key = shuffleKey(seed);
    return nestedShuffle(block, key) ^ nestedShuffle(0, key);
}

uint32_t splitSlotIndex(uint32_t seed, uint32_t sampleid, unsigned slot, unsigned split) {
    const uint32_t visit = sampleid / split;
    const uint32_t order = slotBlock(seed, visit) ^ (slotPlaces(seed, slot, visit) & 0xffffu);
    const uint32_t visits = 0xffffffffu / split + (0xffffffffu % split + 1 == split ? 1 : 0);
    const uint32_t mask = slotOrderMask(visit, visits);
    const uint32_t place = (visit & ~mask) | (order & mask);
    return place * split + jointBranch(seed, visit, sampleid % split, split);
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
