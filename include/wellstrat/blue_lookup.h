// SPDX-License-Identifier: Apache-2.0
//
// The samples of blue.h: computed points (sequence.h), moved in each pixel by digits of its rank.
// This scalar code is the definition; every faster path gives the same bits.
//
//     sampleid ---> shuffle ---> index ---> digits ---(+)---> scrambling ---> [0, 1)
//                      ^                               ^          ^
//     state -----------+-------------------------------|----------+
//     place ---> rank in the tile ---> digits of rank -+
//
// Points and digits of ranks are those of rank.h, which says why samples of all pixels of a block
// together are a net, as those of one pixel are.
//
// Scrambling keeps nets if all pixels of the block have the same. So nothing but the rank may
// depend on the place; the keys of scrambling, shuffles and the exchange of axes are the state's.

#pragma once

#include "wellstrat/blue_domain.h"
#include "wellstrat/sequence_slots.h"

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// A linear map of kRankDigits bits to a word, as the sum of what the lower and the upper six give.
template <typename Word>
struct LinearMap {
    Word of[2][64];

    WELLSTRAT_HOST_DEVICE constexpr Word operator()(uint32_t bits) const {
        return of[0][bits & 63u] ^ of[1][bits >> 6];
    }
};

/// What draws look up, 48 KiB in all: ranks of places, and what these add to points. Slot d takes
/// V_d times the rank (blue_tables.h). V_0 is the identity, so slot 0 is that of padded domains.
struct BlueTables {
    uint16_t padded[2 * kRanks]; ///< by paddedPlace: of the tile, and of the transposed one
    uint16_t slots[kRanks];
    uint16_t flips[8]; ///< what paddedPlace adds by exclusive or, by bits 17 to 19 of its hash
    LinearMap<uint64_t> xy[kJointSlots]; ///< digits of x in the lower half, of y in the upper
    LinearMap<uint32_t> z[kJointSlots];
};

extern WELLSTRAT_API const BlueTables kBlueTables;

WELLSTRAT_HOST_DEVICE inline PointDigits rankDigits(const BlueTables& tables, unsigned slot,
                                                    uint32_t rank) {
    const uint64_t xy = tables.xy[slot](rank);
    return {static_cast<uint32_t>(xy), static_cast<uint32_t>(xy >> 32), tables.z[slot](rank)};
}

/// What is needed of a state; see sequenceSeed.
WELLSTRAT_HOST_DEVICE constexpr uint32_t stateSeed(uint32_t patternid) {
    return sequenceSeed(patternid >> kRankDigits);
}

/// The hash of movedPlace for a state with this seed: another multiple than those of sequence.h.
WELLSTRAT_HOST_DEVICE constexpr uint32_t placeKey(uint32_t seed) {
    return seed * 0x1f83d9abu; // sqrt(17)
}

/// Where BlueTables::padded has the rank of movedPlace(place, hash).
WELLSTRAT_HOST_DEVICE inline uint32_t paddedPlace(const BlueTables& tables, uint32_t place,
                                                  uint32_t hash) {
    return shiftedPlace(place, hash) ^ tables.flips[hash >> 17 & 7u];
}

/// A point moved by the digits of a rank. Pixels of one state that exchange their axes all do.
WELLSTRAT_HOST_DEVICE constexpr PointDigits movedDigits(PointDigits point, PointDigits rank,
                                                        uint32_t seed) {
    const uint32_t x = point.x ^ rank.x, y = point.y ^ rank.y;
    const uint32_t exchanged = (x ^ y) & (0u - (seed >> 31));
    return {x ^ exchanged, y ^ exchanged, point.z ^ rank.z};
}

/// What decides a sample: its point before scrambling, and the seed of that.
struct BluePoint {
    PointDigits digits;
    uint32_t seed;
};

/// Of padded domains: the shuffled sequence. Each state moves the tile in its own way.
WELLSTRAT_HOST_DEVICE inline BluePoint bluePoint(const BlueTables& tables, uint32_t patternid,
                                                 uint32_t sampleid) {
    const uint32_t seed = stateSeed(patternid);
    const uint32_t place = paddedPlace(tables, patternid & kPlaceBits, placeKey(seed));
    const PointDigits rank = rankDigits(tables, 0, tables.padded[place]);
    return {movedDigits(sequencePoint(seed, sampleid), rank, seed), seed};
}

/// Of slots. All slots of a path are stratified together by having one index and one rank, each in
/// its own order; so the tile stays where it is, and the axes are not the order's to exchange.
WELLSTRAT_HOST_DEVICE inline BluePoint blueSlotPoint(const BlueTables& tables,
                                                     const SlotOrders& orders, uint32_t patternid,
                                                     uint32_t sampleid, unsigned slot,
                                                     unsigned split) {
    const uint32_t seed = stateSeed(patternid);
    const PointDigits rank = rankDigits(tables, slot, tables.slots[patternid & kPlaceBits]);
    const PointDigits point = slotDigits(orders, seed & ~kSlotSwapBit, sampleid, slot, split);
    return {movedDigits(point, rank, seed), seed};
}

} // namespace detail

/// Sample `sampleid` of pattern `patternid` in a padded domain: z, (x, y) and (x, y, z) in [0, 1).
/// Any two integers are valid. Safe in any thread.
WELLSTRAT_HOST_DEVICE inline float blueSample1D(const detail::BlueTables& tables,
                                                uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::bluePoint(tables, patternid, sampleid);
    return scrambledSampleZ(point.digits, point.seed);
}
WELLSTRAT_HOST_DEVICE inline Float2 blueSample2D(const detail::BlueTables& tables,
                                                 uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::bluePoint(tables, patternid, sampleid);
    return scrambledSampleXY(point.digits, point.seed);
}
WELLSTRAT_HOST_DEVICE inline Float3 blueSample3D(const detail::BlueTables& tables,
                                                 uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::bluePoint(tables, patternid, sampleid);
    return scrambledSampleXYZ(point.digits, point.seed);
}

/// The same in the domain of a slot, in [0, kJointSlots), under splits by `split` in all, in
/// [1, kMaxJointSplit]; others are undefined.
WELLSTRAT_HOST_DEVICE inline float blueSlotSample1D(const detail::BlueTables& tables,
                                                    const detail::SlotOrders& orders,
                                                    uint32_t patternid, uint32_t sampleid,
                                                    unsigned slot, unsigned split) {
    const detail::BluePoint point =
        detail::blueSlotPoint(tables, orders, patternid, sampleid, slot, split);
    return scrambledSampleZ(point.digits, point.seed);
}
WELLSTRAT_HOST_DEVICE inline Float2 blueSlotSample2D(const detail::BlueTables& tables,
                                                     const detail::SlotOrders& orders,
                                                     uint32_t patternid, uint32_t sampleid,
                                                     unsigned slot, unsigned split) {
    const detail::BluePoint point =
        detail::blueSlotPoint(tables, orders, patternid, sampleid, slot, split);
    return scrambledSampleXY(point.digits, point.seed);
}
WELLSTRAT_HOST_DEVICE inline Float3 blueSlotSample3D(const detail::BlueTables& tables,
                                                     const detail::SlotOrders& orders,
                                                     uint32_t patternid, uint32_t sampleid,
                                                     unsigned slot, unsigned split) {
    const detail::BluePoint point =
        detail::blueSlotPoint(tables, orders, patternid, sampleid, slot, split);
    return scrambledSampleXYZ(point.digits, point.seed);
}

/// The same from the tables of the process.
WELLSTRAT_NOINLINE inline float blueSample1D(uint32_t patternid, uint32_t sampleid) {
    return blueSample1D(detail::kBlueTables, patternid, sampleid);
}
WELLSTRAT_NOINLINE inline Float2 blueSample2D(uint32_t patternid, uint32_t sampleid) {
    return blueSample2D(detail::kBlueTables, patternid, sampleid);
}
WELLSTRAT_NOINLINE inline Float3 blueSample3D(uint32_t patternid, uint32_t sampleid) {
    return blueSample3D(detail::kBlueTables, patternid, sampleid);
}
WELLSTRAT_NOINLINE inline float blueSlotSample1D(uint32_t patternid, uint32_t sampleid,
                                                 unsigned slot, unsigned split) {
    return blueSlotSample1D(detail::kBlueTables, detail::kSlotOrders, patternid, sampleid, slot,
                            split);
}
WELLSTRAT_NOINLINE inline Float2 blueSlotSample2D(uint32_t patternid, uint32_t sampleid,
                                                  unsigned slot, unsigned split) {
    return blueSlotSample2D(detail::kBlueTables, detail::kSlotOrders, patternid, sampleid, slot,
                            split);
}
WELLSTRAT_NOINLINE inline Float3 blueSlotSample3D(uint32_t patternid, uint32_t sampleid,
                                                  unsigned slot, unsigned split) {
    return blueSlotSample3D(detail::kBlueTables, detail::kSlotOrders, patternid, sampleid, slot,
                            split);
}

} // namespace stream1
} // namespace wellstrat
