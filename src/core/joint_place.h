// SPDX-License-Identifier: Apache-2.0
//
// The orders of the slots, from their matrices.

#pragma once

#include "wellstrat/joint_bank.h"
#include "wellstrat/sobol.h"
#include "wellstrat/tables.h"

namespace wellstrat {
inline namespace stream1 {

/// U_d or, swapped, P U_d times the index in [0, kTableSize), column by column.
constexpr uint32_t jointPlaceOf(unsigned slot, unsigned swap, uint32_t index) {
    uint32_t place = 0;
    for (unsigned k = 0; k < kTableSizeLog2; ++k) {
        if (index >> k & 1u) place ^= kJointBank[slot][k];
    }
    return swap == 0 ? place : pascalTimes(place);
}

} // namespace stream1
} // namespace wellstrat
