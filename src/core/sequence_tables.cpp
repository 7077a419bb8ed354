// SPDX-License-Identifier: Apache-2.0

#include "core/made_table.h"
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

WELLSTRAT_MADE DigitsOfBytes makeDigitsOfBytes() {
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

WELLSTRAT_MADE FloatsOfBytes makeFloatsOfBytes() {
    FloatsOfBytes floats{};
    for (unsigned place = 0; place < 3; ++place) {
        for (uint32_t byte = 0; byte < 256; ++byte) {
            floats.of[place][byte] = stream1::toUnitFloat(reverseBits(byte) >> 8 * place);
        }
    }
    return floats;
}

WELLSTRAT_MADE SlotOrders makeSlotOrders() {
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

PointDigits laterPoint(uint32_t seed, uint32_t sampleid) {
    return sequenceDigits(sequenceIndex(seed, sampleid));
}

WELLSTRAT_MADE const DigitsOfBytes kDigitsOfBytes = makeDigitsOfBytes();
WELLSTRAT_MADE const FloatsOfBytes kFloatsOfBytes = makeFloatsOfBytes();
WELLSTRAT_MADE const SlotOrders kSlotOrders = makeSlotOrders();

} // namespace detail
} // namespace stream1
} // namespace wellstrat
