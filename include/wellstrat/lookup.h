// SPDX-License-Identifier: Apache-2.0
//
// What a sample is: a pure function of (patternid, sampleid, coordinate). This scalar code is the
// definition; every faster path gives the same bits.
//
//     pattern ---> table -----------+
//        |                          v
//        +---> nested shuffle ---> point ---> digital shift ---> float in [0, 1)
//     sampleid -----^                              ^
//        pattern ----------------------------------+
//
// Christensen, Kensler and Kilpatrick 2018, "Progressive Multi-Jittered Sample Sequences",
// describe the kind of sequences; the order and the scrambling per pattern are Owen's (owen.h)
// applied to the index and, with a constant for the tree, to the value.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/random.h"
#include "wellstrat/tables.h"
#include "wellstrat/vector.h"

namespace wellstrat {
inline namespace stream1 {

/// What a lookup needs of a pattern: a well-mixed word. All else is this word times a constant.
WELLSTRAT_HOST_DEVICE constexpr uint32_t patternSeed(uint32_t patternid) {
    return mixBits(patternid + detail::kGolden);
}

/// From one block's table to the next: 2^32 / 48, every eighth table.
constexpr uint32_t kBlockStep = 0xffffffffu / (kStratifiedSamples / kTableSize);

/// The table of a block of 4096 samples, `block` in [0, 48). Block 0 has a uniformly random table;
/// the blocks take every eighth table from there on, so the 48 of one pattern differ.
WELLSTRAT_HOST_DEVICE constexpr uint32_t tableOfBlock(uint32_t seed, uint32_t block) {
    return scaleToRange(seed + block * kBlockStep, kTableCount);
}

/// Where in its group of 256 a sample is looked up: a nested shuffle of each aligned group, in
/// which each of the 255 swaps (halves of the group, quarters, ..., neighbours) is decided by a
/// hash of the seed, the group and the place in the tree. Runs of 2^m samples stay such runs.
///
/// Take the index with its bits in opposite order, so that the swap of the halves is the flip of
/// the lowest bit and any other flip may depend on lower bits only. That is what integer addition,
/// multiplication by an odd number, and r ^= r * even do (Klimov and Shamir 2003, "A New Class of
/// Invertible Mappings"; Laine and Karras 2011, section 3.1, use it for scrambling). The number of
/// the group stands below these bits and so takes part in every swap:
///
///     r    | sampleid bits 0 1 2 3 4 5 6 7 |      0      | sampleid bits 17 to 8 |      0      |
///     bit   31                           24 23         18 17                    8 7           0
///
/// That each single swap is fair and that any two, and any four, are independent, within a group
/// and between groups, is tested (tests/statistical/shuffle_test.cpp). Cheaper versions fail
/// there, and so do swaps that are shared by nodes of the tree.
WELLSTRAT_HOST_DEVICE constexpr uint32_t shuffledPlace(uint32_t seed, uint32_t sampleid) {
    uint32_t r = reverseLowByte(sampleid) | (sampleid & ~(kGroupSize - 1));
    r += seed;
    r *= 2 * seed + 1;
    r ^= r * 0x3d20adeau; // multipliers of Vegdahl's hash for the same purpose,
    r ^= r * 0x05526c56u; // https://psychopath.io/post/2021_01_30_building_a_better_lk_hash
    return r >> 24;
}

/// Where the point of a sample lies in the tables. `sampleid` is below kStratifiedSamples.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sampleOffset(uint32_t seed, uint32_t sampleid) {
    const uint32_t groupStart = sampleid % kTableSize & ~(kGroupSize - 1);
    const uint32_t table = tableOfBlock(seed, sampleid / kTableSize);
    return groupStart * kTableCount + table * kGroupSize + shuffledPlace(seed, sampleid);
}

/// What is XORed to x (lower half) and y of all points of a pattern. The multipliers here are
/// fractional parts of square roots of primes: numbers that nobody has chosen.
WELLSTRAT_HOST_DEVICE constexpr uint64_t shiftXY(uint32_t seed) {
    return seed * 0xbb67ae8584caa73bu; // sqrt(3)
}

/// The same for one coordinate.
WELLSTRAT_HOST_DEVICE constexpr uint32_t digitalShift(uint32_t seed, Coordinate coordinate) {
    switch (coordinate) {
    case Coordinate::x: return static_cast<uint32_t>(shiftXY(seed));
    case Coordinate::y: return static_cast<uint32_t>(shiftXY(seed) >> 32);
    default: return seed * 0x3c6ef373u; // sqrt(5)
    }
}

/// z, (x, y) and (x, y, z) of the point at `offset` as a pattern sees it.
WELLSTRAT_HOST_DEVICE inline float tableSampleZ(const uint32_t* words, uint32_t seed,
                                                uint32_t offset) {
    const detail::Words word{words[kTablePoints + offset]};
    return detail::toUnitFloat(word ^ detail::Words{digitalShift(seed, Coordinate::z)});
}
WELLSTRAT_HOST_DEVICE inline Float2 tableSampleXY(const uint32_t* words, uint32_t seed,
                                                  uint32_t offset) {
    return toUnitFloats(words[offset], kPairMultiplier, shiftXY(seed));
}
WELLSTRAT_HOST_DEVICE inline Float3 tableSampleXYZ(const uint32_t* words, uint32_t seed,
                                                   uint32_t offset) {
    const Float2 xy = tableSampleXY(words, seed, offset);
    return {xy.x, xy.y, tableSampleZ(words, seed, offset)};
}

namespace detail {

// Samples beyond the first 4096 of a pattern.

/// Samples from this one on have code of their own, which is not inlined. The threads of a GPU run
/// in step and would all wait for one that goes another way, so there it is only what has no table.
constexpr uint32_t kInlinedSamples = WELLSTRAT_DEVICE_CODE ? kStratifiedSamples : kTableSize;

WELLSTRAT_HOST_DEVICE constexpr bool isLater(uint32_t sampleid) {
    return WELLSTRAT_UNLIKELY(sampleid >= kInlinedSamples);
}

WELLSTRAT_HOST_DEVICE WELLSTRAT_HOST_NOINLINE inline float
laterSample1D(const uint32_t* words, uint32_t patternid, uint32_t sampleid) {
    if (sampleid >= kStratifiedSamples) return randomSample1D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleZ(words, seed, sampleOffset(seed, sampleid));
}

WELLSTRAT_HOST_DEVICE WELLSTRAT_HOST_NOINLINE inline Float2
laterSample2D(const uint32_t* words, uint32_t patternid, uint32_t sampleid) {
    if (sampleid >= kStratifiedSamples) return randomSample2D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXY(words, seed, sampleOffset(seed, sampleid));
}

WELLSTRAT_HOST_DEVICE WELLSTRAT_HOST_NOINLINE inline Float3
laterSample3D(const uint32_t* words, uint32_t patternid, uint32_t sampleid) {
    if (sampleid >= kStratifiedSamples) return randomSample3D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXYZ(words, seed, sampleOffset(seed, sampleid));
}

} // namespace detail

/// Sample `sampleid` of pattern `patternid` from the tables at `words`: z of the point in [0, 1),
/// so that a 1D and a 2D draw from one context make one 3D point. The first 4096 samples, which
/// most patterns never leave, are inlined; what follows from their being in block 0, compilers
/// find out.
WELLSTRAT_HOST_DEVICE inline float sample1D(const uint32_t* words, uint32_t patternid,
                                            uint32_t sampleid) {
    if (detail::isLater(sampleid)) return detail::laterSample1D(words, patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleZ(words, seed, sampleOffset(seed, sampleid));
}

/// The same for (x, y) of the point.
WELLSTRAT_HOST_DEVICE inline Float2 sample2D(const uint32_t* words, uint32_t patternid,
                                             uint32_t sampleid) {
    if (detail::isLater(sampleid)) return detail::laterSample2D(words, patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXY(words, seed, sampleOffset(seed, sampleid));
}

/// The same for the whole point.
WELLSTRAT_HOST_DEVICE inline Float3 sample3D(const uint32_t* words, uint32_t patternid,
                                             uint32_t sampleid) {
    if (detail::isLater(sampleid)) return detail::laterSample3D(words, patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    return tableSampleXYZ(words, seed, sampleOffset(seed, sampleid));
}

/// The same from the tables of the process, which the first call builds. Safe in any thread.
inline float sample1D(uint32_t patternid, uint32_t sampleid) {
    return sample1D(tables(), patternid, sampleid);
}
inline Float2 sample2D(uint32_t patternid, uint32_t sampleid) {
    return sample2D(tables(), patternid, sampleid);
}
inline Float3 sample3D(uint32_t patternid, uint32_t sampleid) {
    return sample3D(tables(), patternid, sampleid);
}

} // namespace stream1
} // namespace wellstrat
