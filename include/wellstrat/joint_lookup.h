// SPDX-License-Identifier: Apache-2.0
//
// The samples of the slots of joint.h: those of lookup.h in another order. This scalar code is the
// definition; every faster path gives the same bits.
//
// Slot d has the linear order U_d (joint_bank.h): sample i of each block of 4096 stands at place
// U_d i of the block's table, bits taken as a vector over GF(2). U_d is upper triangular with a
// diagonal of ones, so that every aligned run of 2^m samples is an aligned run of the table, with
// all its stratification; and as all slots of a path share i, the bank of matrices decides how well
// their samples are stratified together. Table, digital shift and so the set of 4096 points are
// those of lookup.h. In every other pattern, at random, the order is P U_d, P being Pascal's
// triangle modulo 2: this makes y of the point what x was, in distribution, and so neither axis can
// be the lucky one in all pixels. Last, the places of a group of 256 are shifted by a constant of
// the pattern, by exclusive or, which in Owen-scrambled tables changes nothing but the luck.
//
// Under splits by n in all, sampleid = visit * n + branch, and the order is that of the visits: all
// branches of visit s stand together at places n * (U_d s) + [0, n), shuffled among themselves by a
// hash of the visit. (U_d of the sampleid itself would lose most of what slots have in common; an
// order of branches that is the same in each visit would tie those of two slots to each other.) For
// powers of two, aligned runs stay aligned runs; for other n, only those of visits do. P U_d is
// then an order of visits like U_d, and does not change the axes.

#pragma once

#include "wellstrat/lookup.h"
#include "wellstrat/order.h"

namespace wellstrat {
inline namespace stream1 {

// In all that follows, `slot` is in [0, kJointSlots) and `split`, the product of all splits above
// the slot, in [1, kMaxJointSplit]; others are undefined.

/// The samples of a slot are stratified below this sampleid, that of the last visit of which all
/// branches are, and random from there on.
WELLSTRAT_HOST_DEVICE constexpr uint32_t jointStratifiedSamples(unsigned split) {
    return split == 1 ? kStratifiedSamples : kStratifiedSamples - kStratifiedSamples % split;
}

namespace detail {

/// The places U_d i and P U_d i of an index by its low byte and what is above, for all slots d:
/// low[d][i % 256] ^ high[d][i / 256]. Bits 0 to 7 of a place, a number of 12 bits, are in opposite
/// order, as in the tables; the place by P U_d stands 16 bits higher.
struct JointOrders {
    uint32_t low[kJointSlots][256];
    uint32_t high[kJointSlots][kTableSize / 256];
};

extern WELLSTRAT_API const JointOrders kJointOrders;

/// The bit of a pattern's seed that decides whether its order is U_d or P U_d.
constexpr uint32_t kJointSwapBit = 16;

/// A place with its low byte in opposite order.
WELLSTRAT_HOST_DEVICE constexpr uint32_t withReversedByte(uint32_t place) {
    return (place & ~0xffu) | reverseByte(place);
}

/// U_d or P U_d times `index` in [0, kTableSize), for a pattern with this seed, with bits 0 to 7 of
/// the result in opposite order.
WELLSTRAT_HOST_DEVICE inline uint32_t jointPlace(const JointOrders& orders, uint32_t seed,
                                                 unsigned slot, uint32_t index) {
    static_assert(kJointSwapBit == 16, "how much higher the second place stands");
    const uint32_t both = orders.low[slot][index % 256] ^ orders.high[slot][index / 256];
    return (both >> (seed & kJointSwapBit)) & (kTableSize - 1);
}

/// Whether a sample is random. Most are far from it, which needs no division.
WELLSTRAT_HOST_DEVICE constexpr bool isJointRandom(uint32_t sampleid, unsigned split) {
    return WELLSTRAT_UNLIKELY(sampleid > kStratifiedSamples - kMaxJointSplit) &&
           sampleid >= jointStratifiedSamples(split);
}

/// The low bits of a visit that its order changes: all 12, but at the end of the stratified visits
/// only those of the largest aligned run of visits that ends before `visits`. `visit` < `visits`.
WELLSTRAT_HOST_DEVICE constexpr uint32_t jointOrderMask(uint32_t visit, uint32_t visits) {
    uint32_t differing = visit ^ visits;
    if (differing >= kTableSize) return kTableSize - 1; // nearly all
    for (unsigned shift = 1; shift < 32; shift *= 2) differing |= differing >> shift;
    return differing / 2 & (kTableSize - 1);
}

/// The place of a branch in [0, split) among the branches of its visit, shuffled by a hash of
/// pattern and visit. With split = odd * 2^v, branches are `odd` runs of 2^v: the run q becomes run
/// q * 2^e + b modulo `odd`, with random e and b, and in each run there is a nested shuffle of its
/// own, so that aligned runs of up to 2^v stay such runs.
WELLSTRAT_HOST_DEVICE constexpr uint32_t jointBranch(uint32_t seed, uint32_t visit, uint32_t branch,
                                                     unsigned split) {
    const unsigned evenLog2 = trailingZeros(split);
    const uint32_t odd = split >> evenLog2, run = branch >> evenLog2;
    const uint32_t lowBits = (1u << evenLog2) - 1;
    const uint32_t hash = wellstrat::mixBits(seed + visit * kGolden);
    const uint32_t newRun = odd == 1 ? 0 : ((run << (hash & 7u)) + scaleToRange(hash, odd)) % odd;
    const uint32_t shuffled = shuffledPlace(hash + run * kGolden, branch & lowBits);
    return (newRun << evenLog2) + (reverseByte(shuffled) & lowBits);
}

/// Where the point of a sample lies in the tables. The last 8 bits of the seed are added to the
/// place in the group, so that patterns start anywhere in it: patterns of one table have more
/// orders than two, and lookups spread over the lines of the cache.
WELLSTRAT_HOST_DEVICE constexpr uint32_t jointOffsetOf(uint32_t seed, uint32_t block,
                                                       uint32_t place) {
    const uint32_t row = (place / kGroupSize) * kTableCount + tableOfBlock(seed, block);
    return row * kGroupSize + ((place ^ seed) & (kGroupSize - 1));
}

/// The same for a sample without splits, `sampleid` in [0, kStratifiedSamples).
WELLSTRAT_HOST_DEVICE inline uint32_t jointOffset(const JointOrders& orders, uint32_t seed,
                                                  uint32_t sampleid, unsigned slot) {
    return jointOffsetOf(seed, sampleid / kTableSize,
                         jointPlace(orders, seed, slot, sampleid % kTableSize));
}

/// The sampleid at which a table in its own order would have the point of a sample under splits by
/// `split` in all, but for the shift within the group; `sampleid` is below
/// jointStratifiedSamples(split), and so is the result.
WELLSTRAT_HOST_DEVICE inline uint32_t jointIndex(const JointOrders& orders, uint32_t seed,
                                                 uint32_t sampleid, unsigned slot, unsigned split) {
    const uint32_t visit = sampleid / split;
    const uint32_t mask = jointOrderMask(visit, kStratifiedSamples / split);
    const uint32_t ordered = withReversedByte(jointPlace(orders, seed, slot, visit & mask));
    const uint32_t place = (visit & ~mask) | ordered;
    return place * split + jointBranch(seed, visit, sampleid % split, split);
}

/// Where that point lies in the tables.
WELLSTRAT_HOST_DEVICE inline uint32_t jointOffset(const JointOrders& orders, uint32_t seed,
                                                  uint32_t sampleid, unsigned slot,
                                                  unsigned split) {
    const uint32_t index = jointIndex(orders, seed, sampleid, slot, split);
    return jointOffsetOf(seed, index / kTableSize, withReversedByte(index % kTableSize));
}

// Samples of split slots, and those beyond the first 4096 of a pattern.

WELLSTRAT_HOST_DEVICE constexpr bool isOtherJoint(uint32_t sampleid, unsigned split) {
    return WELLSTRAT_UNLIKELY(split != 1 || sampleid >= kInlinedSamples);
}

WELLSTRAT_HOST_DEVICE inline uint32_t otherJointOffset(const JointOrders& orders, uint32_t seed,
                                                       uint32_t sampleid, unsigned slot,
                                                       unsigned split) {
    return split == 1 ? jointOffset(orders, seed, sampleid, slot)
                      : jointOffset(orders, seed, sampleid, slot, split);
}

WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline float
otherJointSample1D(const uint32_t* words, const JointOrders& orders, uint32_t patternid,
                   uint32_t sampleid, unsigned slot, unsigned split) {
    if (isJointRandom(sampleid, split)) return randomSample1D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleZ(words, seed, otherJointOffset(orders, seed, sampleid, slot, split));
}

WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline Float2
otherJointSample2D(const uint32_t* words, const JointOrders& orders, uint32_t patternid,
                   uint32_t sampleid, unsigned slot, unsigned split) {
    if (isJointRandom(sampleid, split)) return randomSample2D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXY(words, seed, otherJointOffset(orders, seed, sampleid, slot, split));
}

WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline Float3
otherJointSample3D(const uint32_t* words, const JointOrders& orders, uint32_t patternid,
                   uint32_t sampleid, unsigned slot, unsigned split) {
    if (isJointRandom(sampleid, split)) return randomSample3D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXYZ(words, seed, otherJointOffset(orders, seed, sampleid, slot, split));
}

} // namespace detail

/// Sample `sampleid` of pattern `patternid`, drawn from a slot under splits by `split` in all, from
/// the tables at `words` by these orders: z, (x, y) and (x, y, z) of its point in [0, 1). Any two
/// integers are valid. Safe in any thread.
WELLSTRAT_HOST_DEVICE inline float jointSample1D(const uint32_t* words,
                                                 const detail::JointOrders& orders,
                                                 uint32_t patternid, uint32_t sampleid,
                                                 unsigned slot, unsigned split) {
    if (detail::isOtherJoint(sampleid, split)) {
        return detail::otherJointSample1D(words, orders, patternid, sampleid, slot, split);
    }
    const uint32_t seed = patternSeed(patternid);
    return tableSampleZ(words, seed, detail::jointOffset(orders, seed, sampleid, slot));
}
WELLSTRAT_HOST_DEVICE inline Float2 jointSample2D(const uint32_t* words,
                                                  const detail::JointOrders& orders,
                                                  uint32_t patternid, uint32_t sampleid,
                                                  unsigned slot, unsigned split) {
    if (detail::isOtherJoint(sampleid, split)) {
        return detail::otherJointSample2D(words, orders, patternid, sampleid, slot, split);
    }
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXY(words, seed, detail::jointOffset(orders, seed, sampleid, slot));
}
WELLSTRAT_HOST_DEVICE inline Float3 jointSample3D(const uint32_t* words,
                                                  const detail::JointOrders& orders,
                                                  uint32_t patternid, uint32_t sampleid,
                                                  unsigned slot, unsigned split) {
    if (detail::isOtherJoint(sampleid, split)) {
        return detail::otherJointSample3D(words, orders, patternid, sampleid, slot, split);
    }
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXYZ(words, seed, detail::jointOffset(orders, seed, sampleid, slot));
}

/// The same by the orders of the process.
inline float jointSample1D(const uint32_t* words, uint32_t patternid, uint32_t sampleid,
                           unsigned slot, unsigned split) {
    return jointSample1D(words, detail::kJointOrders, patternid, sampleid, slot, split);
}
inline Float2 jointSample2D(const uint32_t* words, uint32_t patternid, uint32_t sampleid,
                            unsigned slot, unsigned split) {
    return jointSample2D(words, detail::kJointOrders, patternid, sampleid, slot, split);
}
inline Float3 jointSample3D(const uint32_t* words, uint32_t patternid, uint32_t sampleid,
                            unsigned slot, unsigned split) {
    return jointSample3D(words, detail::kJointOrders, patternid, sampleid, slot, split);
}

} // namespace stream1
} // namespace wellstrat
