// SPDX-License-Identifier: Apache-2.0
//
// The samples of slots (joint.h) from the computed sequence: its points in another order. This
// scalar code is the definition; every faster path gives the same bits.
//
// Slot d takes sample i from index U_d i, by the matrices of the bank (joint_bank.h), or in every
// other pattern, at random, from P U_d i, P being Pascal's triangle modulo 2: joint_lookup.h says
// why. The matrices have as many columns as they have, 2^kSlotDigits samples; from one such block
// to the next, the nested shuffle of sequence.h decides which block of indices is taken, and by an
// exclusive or with what in it, so that the blocks of two slots are paired at random.
//
// Splits are those of joint_lookup.h: visits have the order of the slot, and all branches of a
// visit stand together, shuffled.

#pragma once

#include "wellstrat/joint_bank.h"
#include "wellstrat/joint_lookup.h"
#include "wellstrat/order.h"
#include "wellstrat/sequence.h"

namespace wellstrat {
inline namespace stream1 {

/// The samples of two slots are stratified together in each aligned block of 2^kSlotDigits.
constexpr unsigned kSlotDigits = sizeof kJointBank[0] / sizeof kJointBank[0][0];

namespace detail {

/// What each four digits of an index contribute by exclusive or: [slot][k][bits 4 k to 4 k + 3], to
/// U_d i and, 16 bits higher, to P U_d i.
struct SlotOrders {
    static constexpr unsigned kNibbles = kSlotDigits / 4;
    uint32_t by4[kJointSlots][kNibbles][16];
};
static_assert(kSlotDigits % 4 == 0 && kSlotDigits <= 16, "two places in a word, by four digits");

extern WELLSTRAT_API const SlotOrders kSlotOrders;

/// The bit of a pattern's seed that decides whether its order is U_d or P U_d.
constexpr uint32_t kSlotSwapBit = 1u << 31;

/// U_d and, 16 bits higher, P U_d times the low kSlotDigits bits of an index. The other way round
/// for every other pattern.
WELLSTRAT_HOST_DEVICE inline uint32_t slotPlaces(const SlotOrders& orders, uint32_t seed,
                                                 unsigned slot, uint32_t index) {
    uint32_t both = 0;
    for (unsigned k = 0; k < SlotOrders::kNibbles; ++k) {
        both ^= orders.by4[slot][k][(index >> 4 * k) & 15u];
    }
    const uint32_t turn = seed / kSlotSwapBit * 16; // no branch, which would be a coin's toss
    return (both >> turn) | (both << (32 - turn) % 32);
}

/// Which block follows on which, and by what its indices are shifted: nothing in the first one. By
/// the bits of `sampleid` from kSlotDigits on, some of which are not 0.
WELLSTRAT_HOST_DEVICE WELLSTRAT_HOST_NOINLINE inline uint32_t laterSlotBlock(uint32_t seed,
                                                                             uint32_t sampleid) {
    const uint32_t block = sampleid & ~((1u << kSlotDigits) - 1u);
    const uint32_t key = shuffleKey(seed);
    return nestedShuffle(block, key) ^ nestedShuffle(0, key);
}

WELLSTRAT_HOST_DEVICE inline uint32_t slotBlock(uint32_t seed, uint32_t sampleid) {
    return WELLSTRAT_UNLIKELY(sampleid >> kSlotDigits != 0) ? laterSlotBlock(seed, sampleid) : 0;
}

/// The bits of a visit that its order changes: those below the highest one in which it differs from
/// the number of visits, so that the largest aligned run of whole visits that it is in is kept.
WELLSTRAT_HOST_DEVICE constexpr uint32_t slotOrderMask(uint32_t visit, uint32_t visits) {
    uint32_t differing = visit ^ visits;
    for (unsigned shift = 1; shift < 32; shift *= 2) differing |= differing >> shift;
    return differing / 2;
}

/// The index of a sample of a slot under splits by `split` in all, 2 to kMaxJointSplit.
WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline uint32_t
splitSlotIndex(const SlotOrders& orders, uint32_t seed, uint32_t sampleid, unsigned slot,
               unsigned split) {
    const uint32_t visit = sampleid / split;
    const uint32_t order =
        slotBlock(seed, visit) ^ (slotPlaces(orders, seed, slot, visit) & 0xffffu);
    const uint32_t visits = 0xffffffffu / split + (0xffffffffu % split + 1 == split ? 1 : 0);
    const uint32_t mask = slotOrderMask(visit, visits);
    const uint32_t place = (visit & ~mask) | (order & mask);
    return place * split + jointBranch(seed, visit, sampleid % split, split);
}

} // namespace detail

/// The digits of the point of sample `sampleid`, drawn from a slot under splits by `split` in all,
/// of a pattern with this seed. `slot` is in [0, kJointSlots), `split` in [1, kMaxJointSplit];
/// others are undefined. Without splits, and under those by a power of two, the points of all 2^32
/// samples differ. Under other splits those of whole visits do, the last of which ends before
/// 2^32; the last samples, fewer than `split`, may repeat points of the first ones.
WELLSTRAT_HOST_DEVICE inline PointDigits slotDigits(const detail::SlotOrders& orders, uint32_t seed,
                                                    uint32_t sampleid, unsigned slot,
                                                    unsigned split) {
    if (WELLSTRAT_UNLIKELY(split != 1)) {
        return sequenceDigits(detail::splitSlotIndex(orders, seed, sampleid, slot, split));
    }
    const uint32_t places = detail::slotPlaces(orders, seed, slot, sampleid);
    const uint32_t block = detail::slotBlock(seed, sampleid);
    const uint32_t index = block ^ (places & 0xffffu);
    return {index, pascalTimes(block) ^ (places >> 16), trinomialTimes(index)};
}

/// A coordinate of that sample of pattern `patternid` as a fraction of 2^32.
WELLSTRAT_HOST_DEVICE inline uint32_t jointSequenceBits(const detail::SlotOrders& orders,
                                                        uint32_t patternid, uint32_t sampleid,
                                                        unsigned slot, unsigned split,
                                                        Coordinate coordinate) {
    const uint32_t seed = sequenceSeed(patternid);
    const PointDigits point = slotDigits(orders, seed, sampleid, slot, split);
    return scrambledBits(digitsOf(point, coordinate), seed, coordinate);
}

/// z, (x, y) and (x, y, z) of it in [0, 1): those bits by toUnitFloat.
WELLSTRAT_HOST_DEVICE inline float jointSequenceSample1D(const detail::SlotOrders& orders,
                                                         uint32_t patternid, uint32_t sampleid,
                                                         unsigned slot, unsigned split) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleZ(slotDigits(orders, seed, sampleid, slot, split), seed);
}
WELLSTRAT_HOST_DEVICE inline Float2 jointSequenceSample2D(const detail::SlotOrders& orders,
                                                          uint32_t patternid, uint32_t sampleid,
                                                          unsigned slot, unsigned split) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleXY(slotDigits(orders, seed, sampleid, slot, split), seed);
}
WELLSTRAT_HOST_DEVICE inline Float3 jointSequenceSample3D(const detail::SlotOrders& orders,
                                                          uint32_t patternid, uint32_t sampleid,
                                                          unsigned slot, unsigned split) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleXYZ(slotDigits(orders, seed, sampleid, slot, split), seed);
}

/// The same by the orders of the process.
inline uint32_t jointSequenceBits(uint32_t patternid, uint32_t sampleid, unsigned slot,
                                  unsigned split, Coordinate coordinate) {
    return jointSequenceBits(detail::kSlotOrders, patternid, sampleid, slot, split, coordinate);
}
WELLSTRAT_NOINLINE inline float jointSequenceSample1D(uint32_t patternid, uint32_t sampleid,
                                                      unsigned slot, unsigned split) {
    return jointSequenceSample1D(detail::kSlotOrders, patternid, sampleid, slot, split);
}
WELLSTRAT_NOINLINE inline Float2 jointSequenceSample2D(uint32_t patternid, uint32_t sampleid,
                                                       unsigned slot, unsigned split) {
    return jointSequenceSample2D(detail::kSlotOrders, patternid, sampleid, slot, split);
}
WELLSTRAT_NOINLINE inline Float3 jointSequenceSample3D(uint32_t patternid, uint32_t sampleid,
                                                       unsigned slot, unsigned split) {
    return jointSequenceSample3D(detail::kSlotOrders, patternid, sampleid, slot, split);
}

} // namespace stream1
} // namespace wellstrat
