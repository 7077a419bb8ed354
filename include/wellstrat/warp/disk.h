// SPDX-License-Identifier: Apache-2.0
//
// Unit square to unit disk, with equal areas: the polar and the concentric map. Conventions are in
// warp.h.

#pragma once

#include "wellstrat/warp/angle.h"

namespace wellstrat {
inline namespace stream1 {

/// Per unit area, for both maps.
WELLSTRAT_HOST_DEVICE constexpr float diskPdf() { return detail::kInvPi; }

/// A point with x^2 + y^2 < 1 (up to rounding): radius sqrt(xi.x), azimuth xi.y. Squares near the
/// center become thin; prefer the concentric map where shape matters.
WELLSTRAT_HOST_DEVICE inline Float2 squareToDiskPolar(Float2 xi) {
    return detail::polarPoint(std::sqrt(xi.x), xi.y);
}

WELLSTRAT_HOST_DEVICE inline Float2 diskToSquarePolar(Float2 p) {
    return {detail::clampToUnit(p.x * p.x + p.y * p.y), detail::azimuthTurn(p.x, p.y)};
}

namespace detail {

/// The sample that squareToDiskConcentric takes to a point at a distance of |radius|: concentric
/// squares become circles. (a, b) is the sample in [-1, 1)^2.
struct ConcentricPoint {
    float radius; ///< signed: the larger of a and b by magnitude
    float ratio;  ///< the smaller over the larger, in [-1, 1]
    bool alongX;  ///< a is the larger

    /// The radius, without its sign.
    WELLSTRAT_HOST_DEVICE float distance() const { return radius < 0.0f ? -radius : radius; }

    WELLSTRAT_HOST_DEVICE Float2 point() const {
        const float angle = 0.25f * kPi * ratio;
        const float major = radius * std::cos(angle);
        const float minor = radius * std::sin(angle);
        return alongX ? Float2(major, minor) : Float2(minor, major);
    }
};

WELLSTRAT_HOST_DEVICE inline ConcentricPoint concentricPoint(Float2 xi) {
    const float a = 2.0f * xi.x - 1.0f;
    const float b = 2.0f * xi.y - 1.0f;
    if (a * a > b * b) return {a, b / a, true};
    return {b, b == 0.0f ? 0.0f : a / b, false};
}

} // namespace detail

/// A point with x^2 + y^2 <= 1 (up to rounding). Continuous, with low distortion: squares stay
/// compact. Shirley and Chiu 1997, "A Low Distortion Map Between Disk and Square", Journal of
/// Graphics Tools 2(3), as Cline simplified it to two branches with a signed radius
/// (http://psgraphics.blogspot.com/2011/01/improved-code-for-concentric-map.html); measuring the
/// angle from the nearer axis leaves one sine and cosine within [-pi/4, pi/4] for both.
WELLSTRAT_HOST_DEVICE inline Float2 squareToDiskConcentric(Float2 xi) {
    return detail::concentricPoint(xi).point();
}

WELLSTRAT_HOST_DEVICE inline Float2 diskToSquareConcentric(Float2 p) {
    const bool alongX = p.x * p.x > p.y * p.y;
    const float major = alongX ? p.x : p.y;
    const float minor = alongX ? p.y : p.x;
    const float radius = std::copysign(std::sqrt(p.x * p.x + p.y * p.y), major);
    const float ratio = major == 0.0f ? 0.0f : std::atan(minor / major) * (4.0f * detail::kInvPi);
    const float larger = detail::clampToUnit(0.5f * radius + 0.5f);
    const float smaller = detail::clampToUnit(0.5f * radius * ratio + 0.5f);
    return alongX ? Float2(larger, smaller) : Float2(smaller, larger);
}

} // namespace stream1
} // namespace wellstrat
