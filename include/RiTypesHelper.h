// SPDX-License-Identifier: Apache-2.0
//
// The vector and color types of RenderMan plug-ins, as far as sampling code uses them.

#pragma once

#include "prmanapi.h"
#include "wellstrat/vector.h"

using RtFloat2 = wellstrat::Float2;
using RtFloat3 = wellstrat::Float3;
using RtPoint3 = wellstrat::Float3;
using RtVector3 = wellstrat::Float3;
using RtNormal3 = wellstrat::Float3;

/// A linear color: the weight of a lobe or a path. Not initialized by default.
struct RtColorRGB {
    RtFloat r, g, b;

    RtColorRGB() = default;
    WELLSTRAT_HOST_DEVICE constexpr explicit RtColorRGB(RtFloat gray) : r(gray), g(gray), b(gray) {}
    WELLSTRAT_HOST_DEVICE constexpr RtColorRGB(RtFloat red, RtFloat green, RtFloat blue)
        : r(red), g(green), b(blue) {}

    /// All three channels are exactly 0.
    WELLSTRAT_HOST_DEVICE constexpr bool IsBlack() const {
        return r == 0.0f && g == 0.0f && b == 0.0f;
    }
    WELLSTRAT_HOST_DEVICE constexpr RtFloat ChannelMin() const {
        const RtFloat least = r < g ? r : g;
        return least < b ? least : b;
    }
    WELLSTRAT_HOST_DEVICE constexpr RtFloat ChannelMax() const {
        const RtFloat most = r > g ? r : g;
        return most > b ? most : b;
    }
    WELLSTRAT_HOST_DEVICE constexpr RtFloat ChannelAvg() const { return (r + g + b) / 3.0f; }
};

WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator+(RtColorRGB a, RtColorRGB b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator-(RtColorRGB a, RtColorRGB b) {
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator*(RtColorRGB a, RtColorRGB b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator*(RtColorRGB a, RtFloat s) {
    return {a.r * s, a.g * s, a.b * s};
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator*(RtFloat s, RtColorRGB a) { return a * s; }
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator/(RtColorRGB a, RtColorRGB b) {
    return {a.r / b.r, a.g / b.g, a.b / b.b};
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB operator/(RtColorRGB a, RtFloat s) {
    return {a.r / s, a.g / s, a.b / s};
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB& operator+=(RtColorRGB& a, RtColorRGB b) {
    return a = a + b;
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB& operator-=(RtColorRGB& a, RtColorRGB b) {
    return a = a - b;
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB& operator*=(RtColorRGB& a, RtColorRGB b) {
    return a = a * b;
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB& operator*=(RtColorRGB& a, RtFloat s) {
    return a = a * s;
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB& operator/=(RtColorRGB& a, RtColorRGB b) {
    return a = a / b;
}
WELLSTRAT_HOST_DEVICE constexpr RtColorRGB& operator/=(RtColorRGB& a, RtFloat s) {
    return a = a / s;
}
WELLSTRAT_HOST_DEVICE constexpr bool operator==(RtColorRGB a, RtColorRGB b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}
WELLSTRAT_HOST_DEVICE constexpr bool operator!=(RtColorRGB a, RtColorRGB b) { return !(a == b); }

namespace RixConstants {
constexpr RtColorRGB k_ZeroRGB{0.0f};
constexpr RtColorRGB k_OneRGB{1.0f};
} // namespace RixConstants
