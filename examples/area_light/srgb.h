// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace area_light {

/// IEC 61966-2-1, the sRGB transfer function, in 8 bits.
inline uint8_t encodeSrgb(float linear) {
    const float value = std::min(std::max(linear, 0.0f), 1.0f);
    const float encoded =
        value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
    return static_cast<uint8_t>(std::lround(255.0f * encoded));
}

} // namespace area_light
