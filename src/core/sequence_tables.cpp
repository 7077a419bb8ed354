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

constexpr DigitsOfBytes makeDigitsOfBytes() {
    DigitsOfBytes digits{};
    for (unsigned place = 0; place < 2; ++place) {
        for (uint32_t byte = 0; byte < 256; ++byte) {
            const uint32_t index = reverseBits(byte) >> (place == 0 ? 16 : 24);
            const PointDigits point = sequenceDigits(index);
            digits.xy[place][byte] = point.x | point.y << 16;
            digits.z[place][byte] = static_cast<uint16_t>(point.z);
        }
    }
    return digits;
}

constexpr FloatsOfBytes makeFloatsOfBytes() {
    FloatsOfBytes floats{};
    for (unsigned place = 0; place < 3; ++place) {
        for (uint32_t byte = 0; byte < 256; ++byte) {
            floats.of[place][byte] = stream1::toUnitFloat(reverseBits(byte) >> 8 * place);
        }
    }
    return floats;
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

constexpr DigitsOfBytes kDigitsOfBytes = makeDigitsOfBytes();
constexpr FloatsOfBytes kFloatsOfBytes = makeFloatsOfBytes();
constexpr SlotOrders kSlotOrders = makeSlotOrders();

} // namespace detail
} // namespace stream1
} // namespace wellstrat
