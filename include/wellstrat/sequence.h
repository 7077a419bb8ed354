// SPDX-License-Identifier: Apache-2.0
//
// Computed points: the first three dimensions of the Sobol' sequence for any index of 32 bits, with
// Owen's scrambling by a hash. No tables and no end.
//
//     sampleid ---> nested shuffle ---> index ---> digits of x, y, z ---> scrambling ---> [0, 1)
//                        ^                                                    ^
//     pattern -----------+----------------------------------------------------+
//
// Digits stand in words with the first one, the most significant of the coordinate, in bit 0. In
// that order nested uniform scrambling (owen.h) is a map in which each bit is flipped or not by the
// bits below it, and that is what integer addition, multiplication by an odd number, and
// n ^= n * even do (Klimov and Shamir 2003, "A New Class of Invertible Mappings"; Laine and Karras
// 2011, section 3.1; Burley 2020, "Practical Hash-based Owen Scrambling"). An index in opposite
// order is such a word too, and its scrambling is the nested shuffle of the order of samples.
//
// Start reading at `sequenceBits`, the definition of the samples. Generators that take the points
// in another order, or move them, call what it calls.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/coordinate.h"
#include "wellstrat/hash.h"
#include "wellstrat/sobol.h"
#include "wellstrat/vector.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

namespace detail {
constexpr uint32_t kSequenceKey = 0x73657175u; // "sequ"
} // namespace detail

/// Nested uniform scrambling of 32 digits, the first in bit 0, by a hash: a bijection in which
/// output bit r is input bit r, flipped or not by a function of `key` and of the input bits below
/// r. `key` is a product by an odd number of a well-mixed word: its upper half is well mixed too,
/// and goes into the lower half, since the lowest bit of all such products is the same.
///
/// That each single flip is fair and that any two are independent, in one tree and in the trees of
/// two coordinates, is tested (tests/statistical/sequence_test.cpp); so is the error of integrals,
/// against exact scrambling. docs/decisions/0015-hash-of-the-sequence.md has what else was tried.
WELLSTRAT_HOST_DEVICE constexpr uint32_t owenHash(uint32_t digits, uint32_t key) {
    digits += key ^ (key >> 16);
    digits *= (key >> 16) | 1u;
    digits ^= digits * 0x3d20adeau; // multipliers of Vegdahl's hash for the same purpose,
    digits += key >> 8; // https://psychopath.io/post/2021_01_30_building_a_better_lk_hash
    digits ^= digits * 0x05526c56u;
    return digits;
}

/// A nested shuffle of all indices: every aligned run of 2^m becomes an aligned run of 2^m, for
/// m = 0 to 32, and in each the halves change places or not by a hash of `key` and of the run.
WELLSTRAT_HOST_DEVICE constexpr uint32_t nestedShuffle(uint32_t index, uint32_t key) {
    return reverseBits(owenHash(reverseBits(index), key));
}

/// What is needed of a pattern: a well-mixed word. All keys are this word times a constant.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sequenceSeed(uint32_t patternid) {
    return mixBits(patternid ^ detail::kSequenceKey);
}

/// The keys of owenHash for a coordinate and of nestedShuffle, of a pattern with this seed. The
/// multipliers are fractional parts of square roots of primes: numbers that nobody has chosen.
WELLSTRAT_HOST_DEVICE constexpr uint32_t scramblingKey(uint32_t seed, Coordinate coordinate) {
    switch (coordinate) {
    case Coordinate::x: return seed * 0xbb67ae85u; // sqrt(3)
    case Coordinate::y: return seed * 0x3c6ef373u; // sqrt(5)
    default: return seed * 0xa54ff53bu;            // sqrt(7), rounded to odd
    }
}
WELLSTRAT_HOST_DEVICE constexpr uint32_t shuffleKey(uint32_t seed) {
    return seed * 0x510e527fu; // sqrt(11)
}

/// The digits of a point before they are scrambled, each word with the first one in bit 0.
struct PointDigits {
    uint32_t x, y, z;
};

/// The point of an index. Any 2^m indices from a multiple of 2^m on make a (0,m,2)-net in (x, y)
/// and a (1,m,3)-net in (x, y, z); so do they after an exclusive or of each word with a constant.
WELLSTRAT_HOST_DEVICE constexpr PointDigits sequenceDigits(uint32_t index) {
    return {index, pascalTimes(index), trinomialTimes(index)};
}

/// A coordinate with these digits, scrambled for a pattern with this seed, as a fraction of 2^32.
WELLSTRAT_HOST_DEVICE constexpr uint32_t scrambledBits(uint32_t digits, uint32_t seed,
                                                       Coordinate coordinate) {
    return reverseBits(owenHash(digits, scramblingKey(seed, coordinate)));
}

/// z, (x, y) and (x, y, z) of a point, scrambled for a pattern with this seed, in [0, 1): those
/// bits by toUnitFloat.
WELLSTRAT_HOST_DEVICE constexpr float scrambledSampleZ(PointDigits point, uint32_t seed) {
    return toUnitFloat(scrambledBits(point.z, seed, Coordinate::z));
}
WELLSTRAT_HOST_DEVICE constexpr Float2 scrambledSampleXY(PointDigits point, uint32_t seed) {
    return {toUnitFloat(scrambledBits(point.x, seed, Coordinate::x)),
            toUnitFloat(scrambledBits(point.y, seed, Coordinate::y))};
}
WELLSTRAT_HOST_DEVICE constexpr Float3 scrambledSampleXYZ(PointDigits point, uint32_t seed) {
    const Float2 xy = scrambledSampleXY(point, seed);
    return {xy.x, xy.y, scrambledSampleZ(point, seed)};
}

/// The index of the point of sample `sampleid` of a pattern with this seed.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sequenceIndex(uint32_t seed, uint32_t sampleid) {
    return nestedShuffle(sampleid, shuffleKey(seed));
}

/// A coordinate of sample `sampleid` of pattern `patternid` as a fraction of 2^32. Any two integers
/// are valid: a pattern has 2^32 samples, and no two are alike.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sequenceBits(uint32_t patternid, uint32_t sampleid,
                                                      Coordinate coordinate) {
    const uint32_t seed = sequenceSeed(patternid);
    const PointDigits point = sequenceDigits(sequenceIndex(seed, sampleid));
    switch (coordinate) {
    case Coordinate::x: return scrambledBits(point.x, seed, coordinate);
    case Coordinate::y: return scrambledBits(point.y, seed, coordinate);
    default: return scrambledBits(point.z, seed, coordinate);
    }
}

/// z, (x, y) and (x, y, z) of a sample in [0, 1): those bits by toUnitFloat.
WELLSTRAT_HOST_DEVICE constexpr float sequenceSample1D(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleZ(sequenceDigits(sequenceIndex(seed, sampleid)), seed);
}
WELLSTRAT_HOST_DEVICE constexpr Float2 sequenceSample2D(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleXY(sequenceDigits(sequenceIndex(seed, sampleid)), seed);
}
WELLSTRAT_HOST_DEVICE constexpr Float3 sequenceSample3D(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleXYZ(sequenceDigits(sequenceIndex(seed, sampleid)), seed);
}

} // namespace stream1
} // namespace wellstrat
