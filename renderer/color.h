// SPDX-License-Identifier: Apache-2.0
//
// Arithmetic of linear Rec. 709 colors, which are Float3s.

#pragma once

#include "wellstrat/vector.h"

#include <cmath>

namespace wellstrat::render {

constexpr Float3 multiply(Float3 a, Float3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

constexpr Float3 lerp(Float3 a, Float3 b, float t) { return a * (1.0f - t) + b * t; }

constexpr bool isBlack(Float3 c) { return c.x == 0.0f && c.y == 0.0f && c.z == 0.0f; }

constexpr float largestChannel(Float3 c) {
    const float xy = c.x < c.y ? c.y : c.x;
    return xy < c.z ? c.z : xy;
}

/// The luminance of Rec. 709: ITU-R BT.709-6, item 3.2.
constexpr float luminance(Float3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

/// The nearest number in [0, 1]; 0 for NaN.
constexpr float clamp01(float x) {
    if (!(x > 0.0f)) return 0.0f;
    return x < 1.0f ? x : 1.0f;
}
constexpr Float3 clamp01(Float3 c) { return {clamp01(c.x), clamp01(c.y), clamp01(c.z)}; }

/// IEC 61966-2-1, the transfer function of sRGB.
inline float linearFromSrgb(float v) {
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}
inline Float3 linearFromSrgb(Float3 c) {
    return {linearFromSrgb(c.x), linearFromSrgb(c.y), linearFromSrgb(c.z)};
}

} // namespace wellstrat::render
