// SPDX-License-Identifier: Apache-2.0
//
// What the maps of warp.h share: constants, the azimuth, and the way back into [0, 1).

#pragma once

#include "wellstrat/vector.h"

#include <cmath>

namespace wellstrat {
inline namespace stream1 {

namespace detail {

constexpr float kPi = 3.14159265358979323846f;
constexpr float kTwoPi = 2.0f * kPi;
constexpr float kInvPi = 0.31830988618379067154f;
constexpr float kInvTwoPi = 0.5f * kInvPi;
constexpr float kInvFourPi = 0.25f * kInvPi;

/// The largest float below 1, and the largest sample.
constexpr float kOneMinusEpsilon = 1.0f - 0x1p-24f;

/// Takes what rounding has put outside of [0, 1), and NaN, back to the nearer end.
WELLSTRAT_HOST_DEVICE constexpr float clampToUnit(float x) {
    if (!(x > 0.0f)) return 0.0f;
    return x < 1.0f ? x : kOneMinusEpsilon;
}

/// The point at `radius` from the origin, `turn` of a full turn away from the x axis.
WELLSTRAT_HOST_DEVICE inline Float2 polarPoint(float radius, float turn) {
    const float angle = kTwoPi * turn;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// The azimuth of (x, y) as a fraction of a full turn, in [0, 1); 0 at the origin.
WELLSTRAT_HOST_DEVICE inline float azimuthTurn(float x, float y) {
    const float turn = std::atan2(y, x) * kInvTwoPi;
    return clampToUnit(turn < 0.0f ? turn + 1.0f : turn);
}

} // namespace detail

} // namespace stream1
} // namespace wellstrat
