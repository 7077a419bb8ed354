// SPDX-License-Identifier: Apache-2.0
//
// The orders of the slots as vector code looks them up: by digits of the index.

#pragma once

#include "wellstrat/joint_lookup.h"

namespace wellstrat {
inline namespace stream1 {
namespace batch {

/// What each digit of an index contributes to its place by exclusive or, for one slot: to U_d i and
/// to P U_d i, the swapped one. Bits 0 to 7 of a place, a word of 12 bits, are in opposite order.
struct JointDigits {
    uint32_t by3[4][8];    ///< [k][bits 3 k to 3 k + 2]: the place, the swapped one 16 bits on
    uint32_t by4[3][16];   ///< [k][bits 4 k to 4 k + 3]: likewise
    uint8_t low[2][3][16]; ///< [swapped][k][bits 4 k to 4 k + 3]: bits 0 to 7 of the place
    uint8_t high[2][16];   ///< [swapped][bits 8 to 11]: bits 8 to 11, to which no others contribute
};

extern const JointDigits kJointDigits[kJointSlots];

/// The bit of a pattern's seed that chooses the swapped one.
using detail::kJointSwapBit;

} // namespace batch
} // namespace stream1
} // namespace wellstrat
