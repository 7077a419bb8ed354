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
inline namespace stream1 {

namespace detail {

/// 2^32 / golden ratio, rounded to odd: the usual increment of Weyl sequences (Knuth, TAOCP vol. 3,
/// section 6.4), and a multiplier that spreads consecutive integers.
constexpr uint32_t kGolden = 0x9e3779b9u;

/// The multipliers of `mixBits`, and the bits of the second one that `permuteBits` takes from a
/// key.
constexpr uint32_t kFirstMultiplier = 0x21f0aaadu;
constexpr uint32_t kSecondMultiplier = 0x735a2d97u;
constexpr uint32_t kKeyedBits = 0x3c3c3c3cu;

/// Two rounds of a multiplication and a shift.
WELLSTRAT_HOST_DEVICE constexpr uint32_t mixBits(uint32_t x, uint32_t secondMultiplier) {
    x ^= x >> 16;
    x *= kFirstMultiplier;
    x ^= x >> 15;
    x *= secondMultiplier;
    x ^= x >> 15;
    return x;
}

} // namespace detail

/// A bijection of 32-bit words with full avalanche: flipping any input bit flips each output bit
/// with probability 0.5 +- 0.002 (measured; tests/statistical holds it).
/// The shape is the finalizer of MurmurHash3 (Appleby 2011); shifts and multipliers are the best
/// known two-round set, found by exhaustive search of the bias:
/// https://github.com/skeeto/hash-prospector/issues/19
WELLSTRAT_HOST_DEVICE constexpr uint32_t mixBits(uint32_t x) {
    return detail::mixBits(x, detail::kSecondMultiplier);
}

/// The two words that `permuteBits` needs of a key. Callers with one key and many words compute
/// them once.
struct PermutationKey {
    uint32_t mask, multiplier;
};

/// The words of `key`, from two independent hashes of it. 16 bits of the multiplier come from the
/// key, the others are those of `mixBits`: all 2^16 multipliers mix as well as that one, which
/// random odd numbers do not (docs/decisions/0007-pattern-keys.md).
WELLSTRAT_HOST_DEVICE constexpr PermutationKey permutationKey(uint32_t key) {
    const uint32_t mask = mixBits(key + detail::kGolden);
    const uint32_t keyed = mixBits(mask + detail::kGolden) & detail::kKeyedBits;
    return {mask, keyed ^ detail::kSecondMultiplier};
}

/// For each key a bijection of 32-bit words, with full avalanche in the word and in the key:
/// `mixBits` with a key before it and a key in its second multiplier. Without the latter, the
/// images of a block of words, such as the pixels of a frame, under two keys sometimes share
/// thousands of words.
WELLSTRAT_HOST_DEVICE constexpr uint32_t permuteBits(uint32_t x, PermutationKey key) {
    return detail::mixBits(x ^ key.mask, key.multiplier);
}

/// A hash of two words. For a fixed `a` it is a random function of `b` and no permutation: values
/// repeat as those of independent numbers do (a pseudo-random permutation plus the identity).
WELLSTRAT_HOST_DEVICE constexpr uint32_t hashPair(uint32_t a, uint32_t b) {
    return mixBits(permuteBits(b, permutationKey(a)) + b);
}

} // namespace stream1
} // namespace wellstrat
