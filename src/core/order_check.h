// SPDX-License-Identifier: Apache-2.0
//
// Whether an order, which users may set as they like, is one and has a slot to draw from.

#pragma once

#include "wellstrat/order.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// Says in one line what is wrong with the order, and ends the program.
[[noreturn]] void endForOrder(Order order);

/// Ends the program for an order that deriveOrder never gives.
inline void checkOrder(Order order) {
    if (order.slot == kJointSlots) return;
    if (WELLSTRAT_UNLIKELY(order.slot > kJointSlots || order.splits - 1u >= kMaxJointSplit)) {
        endForOrder(order);
    }
}

/// False for padded domains. Ends the program as checkOrder does.
inline bool hasSlot(Order order) {
    checkOrder(order);
    return order.slot != kJointSlots;
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
