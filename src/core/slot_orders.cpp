// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/sequence_slots.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {
namespace {

/// U_d and, 16 bits higher, P U_d times an index of kSlotDigits bits, column by column.
constexpr uint32_t bothSlotPlaces(unsigned slot, uint32_t index) {
    uint32_t place = 0;
    for (unsigned k = 0; k < kSlotDigits; ++k) {
        if (index >> k & 1u) place ^= kJointBank[slot][k];
    }
    return place | pascalTimes(place) << 16;
}

constexpr SlotOrders makeSlotOrders() {
    SlotOrders orders{};
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        for (unsigned k = 0; k < SlotOrders::kNibbles; ++k) {
            for (uint32_t nibble = 0; nibble < 16; ++nibble) {
                orders.by4[slot][k][nibble] = bothSlotPlaces(slot, nibble << 4 * k);
            }
        }
    }
    return orders;
}

} // namespace

constexpr SlotOrders kSlotOrders = makeSlotOrders();

} // namespace detail
} // namespace stream1
} // namespace wellstrat
