// SPDX-License-Identifier: Apache-2.0
//
// The orders of the slots, from their matrices.

#pragma once

#include "wellstrat/joint_bank.h"
#include "wellstrat/joint_lookup.h"
#include "wellstrat/sobol.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// U_d and, 16 bits higher, P U_d times the index in [0, kTableSize), column by column, the low
/// byte of each in opposite order.
constexpr uint32_t bothJointPlaces(unsigned slot, uint32_t index) {
    uint32_t place = 0;
    for (unsigned k = 0; k < kTableSizeLog2; ++k) {
        if (index >> k & 1u) place ^= kJointBank[slot][k];
    }
    return withReversedByte(place) | withReversedByte(pascalTimes(place)) << 16;
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
