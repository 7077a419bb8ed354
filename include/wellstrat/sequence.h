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
// n ^= 2 n n do (Klimov and Shamir 2003, "A New Class of Invertible Mappings"; Laine and Karras
// 2011, section 3.1, and Burley 2020, "Practical Hash-based Owen Scrambling", scramble in that
// way). An index in opposite order is such a word too, and its scrambling is a nested shuffle of
// the order of samples.
//
// Start reading at `sequenceBits`, the definition of the samples. Generators that take the points
// in another order, or move them, call what it calls.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/coordinate.h"
#include "wellstrat/hash.h"
#include "wellstrat/sobol_digits.h"
#include "wellstrat/vector.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// Nested uniform scrambling of 32 digits, the first in bit 0, by a hash: a bijection in which
/// output bit r is input bit r, flipped or not by a function of `key` and of the input bits below
/// r. `key` is the product of a seed by an odd number: as the lowest bit of all such products is
/// the same, the first digits take those in the middle.
///
/// That each single flip is fair and that any two are independent, in one tree and in the trees of
/// two coordinates, is tested (tests/statistical/sequence_test.cpp), and so is the error of
/// integrals against exact scrambling; docs/decisions/0015-hash-of-the-sequence.md has what else
/// was tried.
WELLSTRAT_HOST_DEVICE constexpr uint32_t owenHash(uint32_t digits, uint32_t key) {
    digits += (key >> 16) | (key << 16);
    digits *= (key >> 7) | 1u;
    return digits ^ (2u * digits * digits);
}

/// A nested shuffle of all indices: every aligned run of 2^m becomes an aligned run of 2^m, for
/// m = 0 to 32, and in each the halves change places or not by a hash of `key` and of the run.
WELLSTRAT_HOST_DEVICE constexpr uint32_t nestedShuffle(uint32_t index, uint32_t key) {
    return reverseBits(owenHash(reverseBits(index), key));
}

namespace detail {

constexpr uint32_t kSequenceKey = 0x73657175u; // "sequ"

/// Bits 0 to 15 of `x` in opposite order, as bits 16 to 31.
WELLSTRAT_HOST_DEVICE constexpr uint32_t reverseLowHalf(uint32_t x) {
    return reverseLowByte(x) | (reverseLowByte(x >> 8) >> 8);
}

} // namespace detail

/// What is needed of a pattern. All keys are this word times an odd constant, which mixes it well:
/// the two together are the rounds of mixBits.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sequenceSeed(uint32_t patternid) {
    uint32_t x = patternid ^ detail::kSequenceKey;
    x ^= x >> 16;
    x *= detail::kFirstMultiplier;
    return x ^ (x >> 15);
}

/// The keys of owenHash for a coordinate of a pattern with this seed, and for the shuffle. The
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

WELLSTRAT_HOST_DEVICE constexpr uint32_t digitsOf(PointDigits point, Coordinate coordinate) {
    if (coordinate == Coordinate::x) return point.x;
    return coordinate == Coordinate::y ? point.y : point.z;
}

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

namespace detail {

/// What each of the first three bytes of digits is worth as a part of a number in [0, 1).
struct FloatsOfBytes {
    float of[3][256];
};

extern WELLSTRAT_API const FloatsOfBytes kFloatsOfBytes;

/// The first 24 digits, the first in bit 0, as a number: toUnitFloat(reverseBits(digits)). Its
/// three parts have no digit in common, so that sums in any order are exact.
WELLSTRAT_HOST_DEVICE inline float floatOfDigits(uint32_t digits) {
#if WELLSTRAT_DEVICE_CODE
    return stream1::toUnitFloat(reverseBits(digits));
#else
    const FloatsOfBytes& floats = kFloatsOfBytes;
    return floats.of[0][digits & 0xffu] +
           (floats.of[1][digits >> 8 & 0xffu] + floats.of[2][digits >> 16 & 0xffu]);
#endif
}

#if WELLSTRAT_VECTOR_PRODUCTS

/// owenHash of x and y, each with its key, as words 0 and 2. What the others hold does not matter.
inline Words owenHashXY(uint32_t x, uint32_t y, uint32_t seed) {
    constexpr WordPairs multipliers{scramblingKey(1, Coordinate::x),
                                    scramblingKey(1, Coordinate::y)};
    const auto key = reinterpret_cast<Words>(products(WordPairs{seed, seed}, multipliers));
    WordPairs digits{x, y};
    digits += reinterpret_cast<WordPairs>(exchangedHalves(key));
    digits = products(digits, reinterpret_cast<WordPairs>(key >> 7 | 1u));
    const auto square = reinterpret_cast<Words>(products(digits, digits));
    return reinterpret_cast<Words>(digits) ^ (square + square);
}

#endif

} // namespace detail

/// z, (x, y) and (x, y, z) of a point, scrambled for a pattern with this seed, in [0, 1): those
/// bits by toUnitFloat.
WELLSTRAT_HOST_DEVICE inline float scrambledSampleZ(PointDigits point, uint32_t seed) {
    return detail::floatOfDigits(owenHash(point.z, scramblingKey(seed, Coordinate::z)));
}
WELLSTRAT_HOST_DEVICE inline Float2 scrambledSampleXY(PointDigits point, uint32_t seed) {
#if WELLSTRAT_VECTOR_PRODUCTS
    const detail::Words digits = detail::owenHashXY(point.x, point.y, seed);
    return {detail::floatOfDigits(digits[0]), detail::floatOfDigits(digits[2])};
#else
    return {detail::floatOfDigits(owenHash(point.x, scramblingKey(seed, Coordinate::x))),
            detail::floatOfDigits(owenHash(point.y, scramblingKey(seed, Coordinate::y)))};
#endif
}
WELLSTRAT_HOST_DEVICE inline Float3 scrambledSampleXYZ(PointDigits point, uint32_t seed) {
    const Float2 xy = scrambledSampleXY(point, seed);
    return {xy.x, xy.y, scrambledSampleZ(point, seed)};
}

/// The same bits themselves, as fractions of 2^32.
WELLSTRAT_HOST_DEVICE constexpr uint32_t scrambledBitsZ(PointDigits point, uint32_t seed) {
    return scrambledBits(point.z, seed, Coordinate::z);
}
WELLSTRAT_HOST_DEVICE constexpr Bits2 scrambledBitsXY(PointDigits point, uint32_t seed) {
    return {scrambledBits(point.x, seed, Coordinate::x),
            scrambledBits(point.y, seed, Coordinate::y)};
}
WELLSTRAT_HOST_DEVICE constexpr Bits3 scrambledBitsXYZ(PointDigits point, uint32_t seed) {
    const Bits2 xy = scrambledBitsXY(point, seed);
    return {xy.x, xy.y, scrambledBitsZ(point, seed)};
}

/// The index of the point of sample `sampleid` of a pattern with this seed: its nested shuffle, by
/// exclusive or with a constant that keeps the first 2^16 samples below 2^16. Under Owen's
/// scrambling that changes nothing but what these cost.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sequenceIndex(uint32_t seed, uint32_t sampleid) {
    const uint32_t key = shuffleKey(seed);
    return nestedShuffle(sampleid, key) ^ (nestedShuffle(0, key) & 0xffff0000u);
}

namespace detail {

/// sequenceDigits of the two bytes of an index below 2^16, each found by what it is in opposite
/// order, the upper byte first: x in the lower half of xy, y in the upper one, and z.
struct DigitsOfBytes {
    uint32_t xy[2][256];
    uint16_t z[2][256];
};

extern WELLSTRAT_API const DigitsOfBytes kDigitsOfBytes;

/// sequencePoint of samples from 2^16 on.
WELLSTRAT_API PointDigits laterPoint(uint32_t seed, uint32_t sampleid);

} // namespace detail

/// sequenceDigits(sequenceIndex(seed, sampleid)).
WELLSTRAT_HOST_DEVICE inline PointDigits sequencePoint(uint32_t seed, uint32_t sampleid) {
#if WELLSTRAT_DEVICE_CODE
    return sequenceDigits(sequenceIndex(seed, sampleid));
#else
    if (WELLSTRAT_UNLIKELY(sampleid >= 0x10000u)) return detail::laterPoint(seed, sampleid);
    const uint32_t shuffled = owenHash(detail::reverseLowHalf(sampleid), shuffleKey(seed));
    const uint32_t lower = shuffled >> 24, upper = (shuffled >> 16) & 0xffu;
    const detail::DigitsOfBytes& digits = detail::kDigitsOfBytes;
    const uint32_t xy = digits.xy[0][upper] ^ digits.xy[1][lower];
    return {xy & 0xffffu, xy >> 16, uint32_t{digits.z[0][upper]} ^ digits.z[1][lower]};
#endif
}

/// A coordinate of sample `sampleid` of pattern `patternid` as a fraction of 2^32. Any two integers
/// are valid: a pattern has 2^32 samples, and no two are alike.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sequenceBits(uint32_t patternid, uint32_t sampleid,
                                                      Coordinate coordinate) {
    const uint32_t seed = sequenceSeed(patternid);
    const PointDigits point = sequenceDigits(sequenceIndex(seed, sampleid));
    return scrambledBits(digitsOf(point, coordinate), seed, coordinate);
}

/// z, (x, y) and (x, y, z) of a sample in [0, 1): those bits by toUnitFloat.
WELLSTRAT_HOST_DEVICE inline float sequenceSample1D(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleZ(sequencePoint(seed, sampleid), seed);
}
WELLSTRAT_HOST_DEVICE inline Float2 sequenceSample2D(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleXY(sequencePoint(seed, sampleid), seed);
}
WELLSTRAT_HOST_DEVICE inline Float3 sequenceSample3D(uint32_t patternid, uint32_t sampleid) {
    const uint32_t seed = sequenceSeed(patternid);
    return scrambledSampleXYZ(sequencePoint(seed, sampleid), seed);
}

} // namespace stream1
} // namespace wellstrat
