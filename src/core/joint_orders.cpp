// SPDX-License-Identifier: Apache-2.0

#include "core/joint_place.h"
#include "wellstrat/joint_lookup.h"

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr JointOrders makeOrders() {
    JointOrders orders{};
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        for (unsigned swap = 0; swap < 2; ++swap) {
            for (unsigned i = 0; i < 256; ++i) {
                orders.low[slot][swap][i] = static_cast<uint8_t>(jointPlaceOf(slot, swap, i));
            }
            for (unsigned i = 0; i < kTableSize / 256; ++i) {
                orders.high[slot][swap][i] =
                    static_cast<uint16_t>(jointPlaceOf(slot, swap, 256 * i));
            }
        }
    }
    return orders;
}

} // namespace

namespace detail {
constexpr JointOrders kJointOrders = makeOrders();
} // namespace detail

} // namespace stream1
} // namespace wellstrat
