// SPDX-License-Identifier: Apache-2.0
//
// Linear maps of bytes over GF(2), as vector code looks them up: by nibbles.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/sobol.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace batch {

/// The image of a byte is low[its bits 0 to 3] ^ high[its bits 4 to 7].
struct ByteMap {
    uint8_t low[16], high[16];
};

template <typename Map>
constexpr ByteMap byteMapOf(Map map) {
    ByteMap result{};
    for (uint32_t nibble = 0; nibble < 16; ++nibble) {
        result.low[nibble] = static_cast<uint8_t>(map(nibble));
        result.high[nibble] = static_cast<uint8_t>(map(nibble << 4));
    }
    return result;
}

alignas(16) inline constexpr ByteMap kReversed = byteMapOf(reverseByte);
alignas(16) inline constexpr ByteMap kPascal = byteMapOf(pascalTimes);
alignas(16) inline constexpr ByteMap kTrinomial = byteMapOf(trinomialTimes);
/// Pascal's triangle times the byte in opposite order.
alignas(16) inline constexpr ByteMap kPascalOfReversed = byteMapOf([](uint32_t byte) {
    return pascalTimes(reverseByte(byte));
});

} // namespace batch
} // namespace stream1
} // namespace wellstrat
