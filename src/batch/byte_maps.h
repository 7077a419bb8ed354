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

/// All that are needed, side by side, so that they take few lines of a cache.
struct ByteMaps {
    ByteMap reversed = byteMapOf(reverseByte);
    /// Pascal's triangle times the byte in opposite order.
    ByteMap pascalOfReversed =
        byteMapOf([](uint32_t byte) { return pascalTimes(reverseByte(byte)); });
    ByteMap pascal = byteMapOf(pascalTimes);
    ByteMap trinomial = byteMapOf(trinomialTimes);
};

alignas(64) inline constexpr ByteMaps kByteMaps;

} // namespace batch
} // namespace stream1
} // namespace wellstrat
