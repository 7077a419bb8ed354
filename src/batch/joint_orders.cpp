// SPDX-License-Identifier: Apache-2.0

#include "batch/joint_orders.h"

#include "wellstrat/joint_bank.h"
#include "wellstrat/sobol.h"

namespace wellstrat {
inline namespace stream1 {
namespace {

/// U_d or P U_d times the index, column by column.
constexpr uint32_t placeOf(unsigned slot, unsigned swap, uint32_t index) {
    uint32_t place = 0;
    for (unsigned k = 0; k < kTableSizeLog2; ++k) {
        if (index >> k & 1u) place ^= kJointBank[slot][k];
    }
    return swap == 0 ? place : pascalTimes(place);
}

constexpr JointOrders makeOrders() {
    JointOrders orders{};
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        for (unsigned swap = 0; swap < 2; ++swap) {
            for (unsigned i = 0; i < 256; ++i) {
                orders.low[slot][swap][i] = static_cast<uint8_t>(placeOf(slot, swap, i));
            }
            for (unsigned i = 0; i < kTableSize / 256; ++i) {
                orders.high[slot][swap][i] = static_cast<uint16_t>(placeOf(slot, swap, 256 * i));
            }
        }
    }
    return orders;
}

/// As JointDigits has it.
constexpr uint32_t reversedPlaceOf(unsigned slot, unsigned swap, uint32_t index) {
    const uint32_t place = placeOf(slot, swap, index);
    return (place & ~0xffu) | reverseByte(place);
}

constexpr batch::JointDigits makeDigits(unsigned slot) {
    batch::JointDigits digits{};
    for (unsigned swap = 0; swap < 2; ++swap) {
        for (unsigned k = 0; k < 4; ++k) {
            for (unsigned digit = 0; digit < 8; ++digit) {
                digits.by3[k][digit] |= reversedPlaceOf(slot, swap, digit << 3 * k) << 16 * swap;
            }
        }
        for (unsigned k = 0; k < 3; ++k) {
            for (unsigned digit = 0; digit < 16; ++digit) {
                const uint32_t place = reversedPlaceOf(slot, swap, digit << 4 * k);
                digits.by4[k][digit] |= place << 16 * swap;
                digits.low[swap][k][digit] = static_cast<uint8_t>(place);
                digits.high[swap][digit] = static_cast<uint8_t>(place >> 8);
            }
        }
    }
    return digits;
}

} // namespace

namespace detail {
constexpr JointOrders kJointOrders = makeOrders();
} // namespace detail

namespace batch {
constexpr JointDigits kJointDigits[kJointSlots] = {
    makeDigits(0),  makeDigits(1),  makeDigits(2),  makeDigits(3), makeDigits(4),  makeDigits(5),
    makeDigits(6),  makeDigits(7),  makeDigits(8),  makeDigits(9), makeDigits(10), makeDigits(11),
    makeDigits(12), makeDigits(13), makeDigits(14), makeDigits(15)};
} // namespace batch

} // namespace stream1
} // namespace wellstrat
