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

/// What a rank adds to x and y. The function of rank.h is N / (1 + z + z^2)^8 with N of degree
/// below 16, and around 1 it is N(z + 1) / (1 + z + z^2)^8. N stands in the lower half of the word,
/// N(z + 1) in the upper; both are linear in the rank.
using RankWord = uint32_t;

/// A linear map of 12 bits to a word, as the sum of what the lower and the upper six give.
struct LinearMap {
    uint32_t of[2][64];

    WELLSTRAT_HOST_DEVICE constexpr uint32_t operator()(uint32_t bits) const {
        return of[0][bits & 63u] ^ of[1][bits >> 6 & 63u];
    }
};

/// What draws look up, 33 KiB in all.
struct BlueTables {
    RankWord padded[kRanks];     ///< of the place's rank
    uint16_t slots[kRanks];      ///< the place's rank
    LinearMap rank[kJointSlots]; ///< of V_d times the rank, for each slot d
    LinearMap z;                 ///< digits of z, by bits 4 to 15 of a rank word
};

extern WELLSTRAT_API const BlueTables kBlueTables;

/// The series of N / (1 + z + z^2)^8 = N (1 + z^8) / (1 + z^24), to 32 digits.
WELLSTRAT_HOST_DEVICE constexpr uint32_t rankSeries(uint32_t numerator) {
    return numerator ^ numerator << 8 ^ numerator << 24;
}

/// What is needed of a state; see sequenceSeed.
WELLSTRAT_HOST_DEVICE constexpr uint32_t stateSeed(uint32_t patternid) {
    return sequenceSeed(patternid >> kRankDigits);
}

/// The key of movedPlace for a state with this seed: another multiple than those of sequence.h.
WELLSTRAT_HOST_DEVICE constexpr uint32_t placeKey(uint32_t seed) {
    return seed * 0x1f83d9abu; // sqrt(17)
}

/// A point moved by a rank. Pixels of one state that exchange their axes all do.
inline PointDigits movedDigits(PointDigits point, RankWord rank, uint32_t seed) {
    point.x ^= rankSeries(rank & 0xffffu);
    point.y ^= rankSeries(rank >> 16);
    point.z ^= kBlueTables.z(rank >> 4);
    const uint32_t exchanged = (point.x ^ point.y) & (0u - (seed >> 31));
    point.x ^= exchanged;
    point.y ^= exchanged;
    return point;
}

/// What decides a sample: its point before scrambling, and the seed of that.
struct BluePoint {
    PointDigits digits;
    uint32_t seed;
};

/// Of padded domains: the shuffled sequence. Each state moves the tile in its own way.
inline BluePoint bluePoint(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = stateSeed(patternid);
    const uint32_t place = movedPlace(patternid & kPlaceBits, placeKey(seed));
    return {movedDigits(sequencePoint(seed, sampleid), kBlueTables.padded[place], seed), seed};
}

/// Of slots. All slots of a path are stratified together by having one index and one rank, each in
/// its own order; so the tile stays where it is, and the axes are not the order's to exchange.
inline BluePoint blueSlotPoint(uint32_t patternid, uint32_t sampleid, unsigned slot,
                               unsigned split) {
    const uint32_t seed = stateSeed(patternid);
    const RankWord rank = kBlueTables.rank[slot](kBlueTables.slots[patternid & kPlaceBits]);
    const PointDigits point = slotDigits(seed & ~kSlotSwapBit, sampleid, slot, split);
    return {movedDigits(point, rank, seed), seed};
}

} // namespace detail

/// Sample `sampleid` of pattern `patternid` in a padded domain: z, (x, y) and (x, y, z) in [0, 1).
/// Any two integers are valid. Safe in any thread.
inline float blueSample1D(uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::bluePoint(patternid, sampleid);
    return scrambledSampleZ(point.digits, point.seed);
}
inline Float2 blueSample2D(uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::bluePoint(patternid, sampleid);
    return scrambledSampleXY(point.digits, point.seed);
}
inline Float3 blueSample3D(uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::bluePoint(patternid, sampleid);
    return scrambledSampleXYZ(point.digits, point.seed);
}

/// The same in the domain of a slot, in [0, kJointSlots), under splits by `split` in all, in
/// [1, kMaxJointSplit]; others are undefined.
inline float blueSlotSample1D(uint32_t patternid, uint32_t sampleid, unsigned slot,
                              unsigned split) {
    const detail::BluePoint point = detail::blueSlotPoint(patternid, sampleid, slot, split);
    return scrambledSampleZ(point.digits, point.seed);
}
inline Float2 blueSlotSample2D(uint32_t patternid, uint32_t sampleid, unsigned slot,
                               unsigned split) {
    const detail::BluePoint point = detail::blueSlotPoint(patternid, sampleid, slot, split);
    return scrambledSampleXY(point.digits, point.seed);
}
inline Float3 blueSlotSample3D(uint32_t patternid, uint32_t sampleid, unsigned slot,
                               unsigned split) {
    const detail::BluePoint point = detail::blueSlotPoint(patternid, sampleid, slot, split);
    return scrambledSampleXYZ(point.digits, point.seed);
}

} // namespace stream1
} // namespace wellstrat
