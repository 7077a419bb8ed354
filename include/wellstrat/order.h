// SPDX-License-Identifier: Apache-2.0
//
// The order of a domain: how it was derived, as far as that decides in which order its samples
// are taken.
//
// A context differs from point to point; the order is the same for all points of a RixRNG. Both are
// values, and both follow from their parent's by a pure function. What an order means is for the
// generator to say: the tables alone know none, a JointProgressive (joint.h) takes the slot and the
// splits from it.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/platform.h"

#include <cstdint>
#include <type_traits>

namespace wellstrat {
inline namespace stream1 {

/// How many slots of jointly stratified domains there are, and the most branches in all that a slot
/// may have.
constexpr unsigned kJointSlots = 16;
constexpr unsigned kMaxJointSplit = 256;

namespace detail {
constexpr unsigned kJointScramble = 0x6a6f696eu; // "join"
} // namespace detail

/// The scramble that derives the domain of `slot`, in [0, kJointSlots). With a larger number it is
/// a scramble like any other, and marks no slot.
WELLSTRAT_HOST_DEVICE constexpr Scramble jointScramble(unsigned slot) {
    return static_cast<Scramble>(detail::kJointScramble + slot);
}

/// The order of a domain. By default that of a camera's: the root order.
struct Order {
    /// The slot that the domain was derived for, in [0, kJointSlots); kJointSlots: none. No other
    /// domain inherits it.
    uint16_t slot = kJointSlots;
    /// The product of all splits since the camera, in [1, kMaxJointSplit]; 0 where it is larger,
    /// and below a distribution: then there are no slots any more, at any depth.
    uint16_t splits = 1;
    /// Of generators that want to know more about a domain, which set it in Generator::ChildOrder.
    /// Inherited.
    uint32_t tag = 0;
};

static_assert(sizeof(Order) == 8 && std::is_trivially_copyable<Order>::value,
              "handed over in a register");

WELLSTRAT_HOST_DEVICE constexpr bool operator==(Order a, Order b) {
    return a.slot == b.slot && a.splits == b.splits && a.tag == b.tag;
}
WELLSTRAT_HOST_DEVICE constexpr bool operator!=(Order a, Order b) { return !(a == b); }

/// The order of the domain `scramble` under a parent of this order. `split` is 1 for a plain new
/// domain, n for a split by n, 0 for distribution.
WELLSTRAT_HOST_DEVICE constexpr Order deriveOrder(Order parent, Scramble scramble, unsigned split) {
    Order child;
    child.tag = parent.tag;
    const bool kept = split != 0 && parent.splits != 0 && split <= kMaxJointSplit / parent.splits;
    child.splits = static_cast<uint16_t>(kept ? parent.splits * split : 0);
    const unsigned slot = static_cast<unsigned>(scramble) - detail::kJointScramble;
    child.slot = static_cast<uint16_t>(kept && slot < kJointSlots ? slot : kJointSlots);
    return child;
}

/// The order of contexts of which only the parent is known that they came from: no slot, and the
/// parent's splits, since slots below must know them. If the parent has none, the root order.
WELLSTRAT_HOST_DEVICE constexpr Order viewOrder(Order parent) {
    parent.slot = kJointSlots;
    return parent;
}

/// The order of a slot's domain under splits by `splits` in all, for those who draw from slots
/// without a RixRNG. `slot` is in [0, kJointSlots), `splits` in [1, kMaxJointSplit]; what is out of
/// range marks no slot.
WELLSTRAT_HOST_DEVICE constexpr Order jointOrder(unsigned slot, unsigned splits = 1) {
    return deriveOrder(Order{}, jointScramble(slot < kJointSlots ? slot : kJointSlots), splits);
}

} // namespace stream1
} // namespace wellstrat
