// SPDX-License-Identifier: Apache-2.0

#include "core/joint_place.h"
#include "core/made_table.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {
namespace {

WELLSTRAT_MADE JointOrders makeOrders() {
    JointOrders orders{};
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        for (unsigned i = 0; i < 256; ++i) orders.low[slot][i] = bothJointPlaces(slot, i);
        for (unsigned i = 0; i < kTableSize / 256; ++i) {
            orders.high[slot][i] = bothJointPlaces(slot, 256 * i);
        }
    }
    return orders;
}

} // namespace

WELLSTRAT_MADE const JointOrders kJointOrders = makeOrders();

} // namespace detail
} // namespace stream1
} // namespace wellstrat
