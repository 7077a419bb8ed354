// SPDX-License-Identifier: Apache-2.0

#include "core/order_check.h"

#include <cstdio>
#include <cstdlib>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

void endForOrder(Order order) {
    std::fprintf(stderr,
                 "wellstrat: an order has slot %u under splits by %u; there are slots 0 to %u and "
                 "splits by 1 to %u\n",
                 unsigned{order.slot}, unsigned{order.splits}, kJointSlots - 1, kMaxJointSplit);
    std::abort();
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
