// SPDX-License-Identifier: Apache-2.0
//
// Nested uniform scrambling in base 2.
// Owen 1995, "Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences", section 3.
//
// The binary digits of a coordinate are a path from the root of a binary tree; each node has a
// random bit of its own that decides whether its two halves change places:
//
//     node            1          digit 1 is flipped by bit(1)
//                 2       3      digit 2 by bit(2) or bit(3), as the first digit was 0 or 1
//               4   5   6   7    and so on
//
// Here the bits are a hash of (seed, node), 32 nodes to a hashed word. Cheaper versions, such as
// the multiplications of Laine and Karras 2011, only approach this: they cannot reach all
// permutations. The tables are built once, so they take the real thing.

#pragma once

#include "wellstrat/hash.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// The hashed bits of nodes 32 * word to 32 * word + 31, node's bit n at n % 32.
WELLSTRAT_HOST_DEVICE constexpr uint32_t owenNodeBits(uint32_t seed, uint32_t word) {
    return hashPair(seed, word);
}

/// Scrambles the first `digits` binary digits of `value`, a fraction of 2^32; the others are kept.
/// `digits` is in [0, 32]. Equal seeds give the same scrambling, a bijection that maps every
/// elementary interval of 2^(32-digits) or more values onto one of the same size.
WELLSTRAT_HOST_DEVICE constexpr uint32_t owenScramble(uint32_t value, uint32_t seed,
                                                      unsigned digits = 32) {
    uint32_t flips = 0;
    uint32_t node = 1;
    for (unsigned digit = 0; digit < digits; ++digit) {
        const uint32_t bit = (owenNodeBits(seed, node >> 5) >> (node & 31u)) & 1u;
        flips |= bit << (31 - digit);
        node = (node << 1) | ((value >> (31 - digit)) & 1u);
    }
    return value ^ flips;
}

} // namespace stream1
} // namespace wellstrat
