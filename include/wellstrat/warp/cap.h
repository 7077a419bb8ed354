// SPDX-License-Identifier: Apache-2.0
//
// Unit square to directions of equal density: the cone, and as special cases the hemisphere and the
// sphere. Conventions are in warp.h. By Archimedes, the area of a cap of the sphere is
// proportional to its height; Shirley et al. 1996, "Monte Carlo Techniques for Direct Lighting
// Calculations", ACM TOG 15(1), section 3.2, sample spherical lights so.

#pragma once

#include "wellstrat/warp/angle.h"

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// 1 - z of a direction, without cancellation near the axis.
WELLSTRAT_HOST_DEVICE inline float depthBelowPole(Float3 d) {
    return d.z > 0.0f ? (d.x * d.x + d.y * d.y) / (1.0f + d.z) : 1.0f - d.z;
}

/// The direction with this 1 - z and azimuth.
WELLSTRAT_HOST_DEVICE inline Float3 directionAtDepth(float depth, float turn) {
    const Float2 xy = polarPoint(std::sqrt(depth * (2.0f - depth)), turn);
    return {xy.x, xy.y, 1.0f - depth};
}

} // namespace detail

/// A direction with z in (cosThetaMax, 1], for cosThetaMax in [-1, 1). For cones narrower than
/// about 0.1 degrees the half angle is only as good as 1 - cosThetaMax is in float.
WELLSTRAT_HOST_DEVICE inline Float3 squareToCone(Float2 xi, float cosThetaMax) {
    return detail::directionAtDepth(xi.x * (1.0f - cosThetaMax), xi.y);
}

WELLSTRAT_HOST_DEVICE inline Float2 coneToSquare(Float3 d, float cosThetaMax) {
    return {detail::clampToUnit(detail::depthBelowPole(d) / (1.0f - cosThetaMax)),
            detail::azimuthTurn(d.x, d.y)};
}

/// Per unit solid angle.
WELLSTRAT_HOST_DEVICE constexpr float conePdf(float cosThetaMax) {
    return detail::kInvTwoPi / (1.0f - cosThetaMax);
}

/// A direction with z in (0, 1]: z = 1 - xi.x.
WELLSTRAT_HOST_DEVICE inline Float3 squareToHemisphere(Float2 xi) { return squareToCone(xi, 0.0f); }
WELLSTRAT_HOST_DEVICE inline Float2 hemisphereToSquare(Float3 d) { return coneToSquare(d, 0.0f); }
WELLSTRAT_HOST_DEVICE constexpr float hemispherePdf() { return detail::kInvTwoPi; }

/// A direction with z in (-1, 1]: z = 1 - 2 xi.x.
WELLSTRAT_HOST_DEVICE inline Float3 squareToSphere(Float2 xi) { return squareToCone(xi, -1.0f); }
WELLSTRAT_HOST_DEVICE inline Float2 sphereToSquare(Float3 d) { return coneToSquare(d, -1.0f); }
WELLSTRAT_HOST_DEVICE constexpr float spherePdf() { return detail::kInvFourPi; }

} // namespace stream1
} // namespace wellstrat
