// SPDX-License-Identifier: Apache-2.0
//
// The integer hashes under everything random here. They use 32-bit additions, multiplications and
// shifts only, so that SIMD code of any width computes the same bits.
//
// Start reading at `mixBits`; the other two are built from it.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>

namespace wellstrat {

/// A bijection of 32-bit words with full avalanche: flipping any input bit flips each output bit
/// with probability 0.5 +- 0.002 (measured; tests/statistical holds it).
/// The shape is the finalizer of MurmurHash3 (Appleby 2011); shifts and multipliers are the best
/// known two-round set, found by exhaustive search of the bias:
/// https://github.com/skeeto/hash-prospector/issues/19
WELLSTRAT_HOST_DEVICE constexpr uint32_t mixBits(uint32_t x) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0x735a2d97u;
    x ^= x >> 15;
    return x;
}

namespace detail {

/// 2^32 / golden ratio, rounded to odd: the usual increment of Weyl sequences (Knuth, TAOCP vol. 3,
/// section 6.4), and a multiplier that spreads consecutive integers.
constexpr uint32_t kGolden = 0x9e3779b9u;

} // namespace detail

/// The two words that `permuteBits` needs of a key. Callers with one key and many words compute
/// them once.
struct PermutationKey {
    uint32_t first, second;
};

/// The words of `key`: two independent hashes of it.
WELLSTRAT_HOST_DEVICE constexpr PermutationKey permutationKey(uint32_t key) {
    const uint32_t first = mixBits(key + detail::kGolden);
    return {first, mixBits(first + detail::kGolden)};
}

/// For each key a bijection of 32-bit words, with full avalanche in the word and in the key. One
/// `mixBits` with parts of the key before each round is not enough: the images of a block of words,
/// such as the pixels of a frame, under two keys then sometimes share thousands of words
/// (docs/decisions/0007-pattern-keys.md).
WELLSTRAT_HOST_DEVICE constexpr uint32_t permuteBits(uint32_t x, PermutationKey key) {
    return mixBits(mixBits(x ^ key.first) + key.second);
}

/// A hash of two words. For a fixed `a` it is a random function of `b` and no permutation: values
/// repeat as those of independent numbers do (a pseudo-random permutation plus the identity).
WELLSTRAT_HOST_DEVICE constexpr uint32_t hashPair(uint32_t a, uint32_t b) {
    return mixBits(permuteBits(b, permutationKey(a)) + b);
}

} // namespace wellstrat
