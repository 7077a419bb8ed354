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
#include "wellstrat/joint_lookup.h"
#include "wellstrat/sequence.h"

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// What a rank adds to x and y. The function of rank.h is N / (1 + z + z^2)^8 with N of degree
/// below 16, and around 1 it is N(z + 1) / (1 + z + z^2)^8. N stands in the lower half of the word,
/// N(z + 1) in the upper; both are linear in the rank.
using RankWord = uint32_t;

/// A linear map of 12 bits, by the bits 4 k to 4 k + 3: the sum of [k][these bits].
template <typename T>
struct Map12 {
    T of[3][16];

    WELLSTRAT_HOST_DEVICE constexpr T operator()(uint32_t bits) const {
        return static_cast<T>(of[0][bits & 15u] ^ of[1][bits >> 4 & 15u] ^ of[2][bits >> 8 & 15u]);
    }
};

/// What draws look up, 29 KiB in all.
struct BlueTables {
    RankWord padded[kRanks];            ///< of the place's rank
    uint16_t slots[kRanks];             ///< the place's rank
    Map12<RankWord> rank[kJointSlots];  ///< of V_d times the rank, for each slot d
    Map12<uint16_t> order[kJointSlots]; ///< U_d times an index (joint_bank.h)
    Map12<uint32_t> z;                  ///< digits of z, by bits 4 to 15 of a rank word
};

extern WELLSTRAT_API const BlueTables kBlueTables;

/// The series of N / (1 + z + z^2)^8 = N (1 + z^8) / (1 + z^24), to 32 digits.
WELLSTRAT_HOST_DEVICE constexpr uint32_t rankSeries(uint32_t numerator) {
    return numerator ^ numerator << 8 ^ numerator << 24;
}

/// The point of an index, moved by a rank. Pixels of one state that exchange their axes all do.
inline PointDigits blueDigits(uint32_t index, RankWord rank, uint32_t seed) {
    PointDigits point = sequenceDigits(index);
    point.x ^= rankSeries(rank & 0xffffu);
    point.y ^= rankSeries(rank >> 16);
    point.z ^= kBlueTables.z(rank >> 4);
    const uint32_t exchanged = (point.x ^ point.y) & (0u - (seed >> 31));
    point.x ^= exchanged;
    point.y ^= exchanged;
    return point;
}

/// What decides a sample: the unscrambled point, and the seed of its scrambling.
struct BluePoint {
    PointDigits digits;
    uint32_t seed;
};

/// Of padded domains: the shuffled sequence. Each state moves the tile in its own way.
inline BluePoint paddedBluePoint(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = stateSeed(patternid);
    const uint32_t place = movedPlace(patternid & kPlaceBits, placeKey(seed));
    return {blueDigits(sequenceIndex(seed, sampleid), kBlueTables.padded[place], seed), seed};
}

/// Where a sample of a slot stands under splits by `split` in all: visits in the slot's order, the
/// branches of each shuffled, as in joint_lookup.h but for all sampleids.
inline uint32_t blueSlotIndex(uint32_t patternid, uint32_t sampleid, unsigned slot,
                              unsigned split) {
    const uint32_t visit = split == 1 ? sampleid : sampleid / split;
    const uint32_t place = (visit & ~(kTableSize - 1)) | kBlueTables.order[slot](visit);
    if (split == 1) return place;
    return place * split + jointBranch(stateSeed(patternid), visit, sampleid % split, split);
}

/// Of slots: all that have one index and one rank, whatever their states, are stratified together,
/// so neither is shuffled. Blocks of 4096 samples have seeds of their own.
inline BluePoint blueSlotPoint(uint32_t patternid, uint32_t sampleid, unsigned slot,
                               unsigned split) {
    const uint32_t index = blueSlotIndex(patternid, sampleid, slot, split);
    const uint32_t seed = stateSeed(patternid, index / kTableSize);
    const RankWord rank = kBlueTables.rank[slot](kBlueTables.slots[patternid & kPlaceBits]);
    return {blueDigits(index % kTableSize, rank, seed), seed};
}

} // namespace detail

/// Sample `sampleid` of pattern `patternid` in a padded domain: z, (x, y) and (x, y, z) in [0, 1).
/// Any two integers are valid. Safe in any thread.
inline float blueSample1D(uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::paddedBluePoint(patternid, sampleid);
    return scrambledSampleZ(point.digits, point.seed);
}
inline Float2 blueSample2D(uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::paddedBluePoint(patternid, sampleid);
    return scrambledSampleXY(point.digits, point.seed);
}
inline Float3 blueSample3D(uint32_t patternid, uint32_t sampleid) {
    const detail::BluePoint point = detail::paddedBluePoint(patternid, sampleid);
    return scrambledSampleXYZ(point.digits, point.seed);
}

/// The same in the domain of a slot, in [0, kJointSlots), under splits by `split` in all, in
/// [1, kMaxJointSplit]; others are undefined. Only powers of two keep runs of samples nets; with
/// others, runs of visits are spread evenly.
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
