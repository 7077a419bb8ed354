// SPDX-License-Identifier: Apache-2.0
//
// Whether an order, which users may set as they like, has a slot to draw from.

#pragma once

#include "wellstrat/order.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// Says in one line what is wrong with the order, and ends the program.
[[noreturn]] void endForOrder(Order order);

/// False for padded domains. Ends the program for what is no order of a slot.
inline bool hasSlot(Order order) {
    if (order.slot == kJointSlots) return false;
    if (WELLSTRAT_UNLIKELY(order.slot > kJointSlots || order.splits - 1u >= kMaxJointSplit)) {
        endForOrder(order);
    }
    return true;
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
