// SPDX-License-Identifier: Apache-2.0

#include "batch/joint_digits.h"

#include "core/joint_place.h"
#include "core/made_table.h"

namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace {

WELLSTRAT_MADE JointDigits makeDigits(unsigned slot) {
    JointDigits digits{};
    for (unsigned k = 0; k < 4; ++k) {
        for (unsigned digit = 0; digit < 8; ++digit) {
            digits.by3[k][digit] = detail::bothJointPlaces(slot, digit << 3 * k);
        }
    }
    for (unsigned k = 0; k < 3; ++k) {
        for (unsigned digit = 0; digit < 16; ++digit) {
            const uint32_t both = detail::bothJointPlaces(slot, digit << 4 * k);
            digits.by4[k][digit] = both;
            for (unsigned swap = 0; swap < 2; ++swap) {
                const uint32_t place = both >> 16 * swap;
                digits.low[swap][k][digit] = static_cast<uint8_t>(place);
                digits.high[swap][digit] = static_cast<uint8_t>(place >> 8 & 0xfu);
            }
        }
    }
    return digits;
}

} // namespace

WELLSTRAT_MADE const JointDigits kJointDigits[kJointSlots] = {
    makeDigits(0),  makeDigits(1),  makeDigits(2),  makeDigits(3), makeDigits(4),  makeDigits(5),
    makeDigits(6),  makeDigits(7),  makeDigits(8),  makeDigits(9), makeDigits(10), makeDigits(11),
    makeDigits(12), makeDigits(13), makeDigits(14), makeDigits(15)};

} // namespace batch
} // namespace stream1
} // namespace wellstrat
