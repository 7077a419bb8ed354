// SPDX-License-Identifier: Apache-2.0
//
// Unit square to directions around a surface normal, the z axis: cosine-weighted, power-cosine and
// GGX visible normals. Conventions are in warp.h. All densities are per unit solid angle, and 0 for
// directions with z <= 0.

#pragma once

#include "wellstrat/warp/disk.h"

namespace wellstrat {
inline namespace stream1 {

/// A direction with z in [2^-12, 1], with probability proportional to z: the point of the
/// concentric disk, lifted to the hemisphere (Malley's method; Pharr, Jakob and Humphreys,
/// "Physically Based Rendering", section A.5.3).
WELLSTRAT_HOST_DEVICE inline Float3 squareToHemisphereCosine(Float2 xi) {
    const detail::ConcentricPoint disk = detail::concentricPoint(xi);
    const Float2 xy = disk.point();
    const float r = disk.distance();
    // The bound stands for the rim, where z would be 0: half a step of xi away z is above it.
    const float zSquared = std::fmax((1.0f - r) * (1.0f + r), 0x1p-24f);
    return {xy.x, xy.y, std::sqrt(zSquared)};
}

WELLSTRAT_HOST_DEVICE inline Float2 hemisphereCosineToSquare(Float3 d) {
    return diskToSquareConcentric({d.x, d.y});
}

WELLSTRAT_HOST_DEVICE constexpr float hemisphereCosinePdf(float cosTheta) {
    return cosTheta > 0.0f ? cosTheta * detail::kInvPi : 0.0f;
}

/// A direction with z in (0, 1], with probability proportional to z^exponent. exponent >= 0; 0
/// gives the uniform hemisphere and 1 the cosine-weighted one, in polar coordinates. Blinn-Phong
/// lobes: Phong 1975; Lafortune and Willems 1994, "Using the Modified Phong Reflectance Model for
/// Physically Based Rendering", section 4.
WELLSTRAT_HOST_DEVICE inline Float3 squareToPowerCosine(Float2 xi, float exponent) {
    // z = (1 - xi.x)^(1 / (exponent + 1)), by logarithms so that narrow lobes keep their precision.
    const float logZ = std::log1p(-xi.x) / (exponent + 1.0f);
    const Float2 xy = detail::polarPoint(std::sqrt(-std::expm1(2.0f * logZ)), xi.y);
    return {xy.x, xy.y, std::exp(logZ)};
}

/// d.z > 0.
WELLSTRAT_HOST_DEVICE inline Float2 powerCosineToSquare(Float3 d, float exponent) {
    const float sinSquared = d.x * d.x + d.y * d.y;
    const float logZ = sinSquared < 0.5f ? 0.5f * std::log1p(-sinSquared) : std::log(d.z);
    return {detail::clampToUnit(-std::expm1((exponent + 1.0f) * logZ)),
            detail::azimuthTurn(d.x, d.y)};
}

WELLSTRAT_HOST_DEVICE inline float powerCosinePdf(float cosTheta, float exponent) {
    if (!(cosTheta > 0.0f)) return 0.0f;
    return (exponent + 1.0f) * detail::kInvTwoPi * std::pow(cosTheta, exponent);
}

namespace detail {

WELLSTRAT_HOST_DEVICE inline Float3 normalized(Float3 v) { return v / v.Length(); }

/// Half of a chord of the unit disk, at a distance of |x| from the center.
WELLSTRAT_HOST_DEVICE inline float halfChord(float x) {
    return std::sqrt(std::fmax(0.0f, (1.0f - x) * (1.0f + x)));
}

/// The space where the GGX microsurface is the unit hemisphere, seen from `view`. The visible part
/// of the hemisphere, projected along `view`, is a half disk, where axisY > 0, and a half ellipse.
struct VisibleHemisphere {
    Float3 view, axisX, axisY; ///< an orthonormal frame
    float share;               ///< the visible area of the disk, in (1/2, 1]

    WELLSTRAT_HOST_DEVICE VisibleHemisphere(Float3 viewDirection, float alphaX, float alphaY)
        : view(normalized({alphaX * viewDirection.x, alphaY * viewDirection.y, viewDirection.z})) {
        axisX = Float3(-view.y, view.x, 0.0f);
        // Below this bound any axis will do, and the length is no longer precise.
        if (axisX.LengthSq() < 1e-20f) axisX = Float3(1.0f, 0.0f, 0.0f);
        axisX.Normalize();
        axisY = Cross(view, axisX);
        share = 0.5f + 0.5f * view.z;
    }
};

} // namespace detail

/// A microfacet normal m with z > 0, distributed as the GGX normals of roughness (alphaX, alphaY)
/// that `view` sees. The roughness is that of the distribution, above 0, and not its square root;
/// `view` has length 1, points away from the surface, and has z > 0. Reflecting `view` at m gives
/// a direction of density ggxVisibleNormalPdf / (4 Dot(view, m)), which may lie below the surface.
///
/// Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), but over the
/// concentric disk, so that there is no seam. The map of Dupuy and Benyoub 2023 through spherical
/// caps takes fewer operations, but it pinches all normals at right angles to `view` into one
/// point of the square: strata there are torn apart, and in float some of the normals face away.
WELLSTRAT_HOST_DEVICE inline Float3 squareToGgxVisibleNormal(Float2 xi, Float3 view, float alphaX,
                                                             float alphaY) {
    const detail::VisibleHemisphere visible(view, alphaX, alphaY);
    const Float2 disk = squareToDiskConcentric(xi);
    const float y = (1.0f - visible.share) * detail::halfChord(disk.x) + visible.share * disk.y;
    const float z = std::sqrt(std::fmax(0.0f, 1.0f - disk.x * disk.x - y * y));
    const Float3 h = visible.axisX * disk.x + visible.axisY * y + visible.view * z;
    return detail::normalized({alphaX * h.x, alphaY * h.y, std::fmax(h.z, 0x1p-24f)});
}

/// m.z > 0 and Dot(view, m) > 0.
WELLSTRAT_HOST_DEVICE inline Float2 ggxVisibleNormalToSquare(Float3 m, Float3 view, float alphaX,
                                                             float alphaY) {
    const detail::VisibleHemisphere visible(view, alphaX, alphaY);
    const Float3 h = detail::normalized({m.x / alphaX, m.y / alphaY, m.z});
    const float x = Dot(h, visible.axisX);
    const float y = Dot(h, visible.axisY) - (1.0f - visible.share) * detail::halfChord(x);
    return diskToSquareConcentric({x, y / visible.share});
}

/// The density of m: D(m) G1(view) Dot(view, m) / view.z, with the masking G1 of Smith. Heitz 2014,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), equations
/// 16, 85 and 86.
WELLSTRAT_HOST_DEVICE inline float ggxVisibleNormalPdf(Float3 m, Float3 view, float alphaX,
                                                       float alphaY) {
    const float cosine = Dot(view, m);
    if (!(m.z > 0.0f) || !(cosine > 0.0f)) return 0.0f;
    const Float3 h(m.x / alphaX, m.y / alphaY, m.z);
    const float lengthSq = h.LengthSq();
    const float d = detail::kInvPi / (alphaX * alphaY * lengthSq * lengthSq);
    const Float3 v(alphaX * view.x, alphaY * view.y, view.z);
    return d * cosine * 2.0f / (view.z + v.Length());
}

} // namespace stream1
} // namespace wellstrat
