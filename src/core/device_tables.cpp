// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/device_tables.h"

#include <cstring>

namespace wellstrat {
inline namespace stream1 {

void copyDeviceTables(void* block, DeviceDraws draws) {
    const auto copy = [block](std::size_t offset, const void* part, std::size_t size) {
        std::memcpy(static_cast<unsigned char*>(block) + offset, part, size);
    };
    copy(offsetof(DeviceTables, slotOrders), &detail::kSlotOrders, sizeof detail::kSlotOrders);
    copy(offsetof(DeviceTables, blueTables), &detail::kBlueTables, sizeof detail::kBlueTables);
    copy(offsetof(DeviceTables, jointOrders), &detail::kJointOrders, sizeof detail::kJointOrders);
    if (draws == DeviceDraws::computed) return;
    copy(offsetof(DeviceTables, words), tables(),
         deviceTableBytes(draws) - offsetof(DeviceTables, words));
}

} // namespace stream1
} // namespace wellstrat
