// SPDX-License-Identifier: Apache-2.0
//
// Unit square to directions around a surface normal, the z axis: cosine-weighted, power-cosine and
// GGX visible normals. Conventions are in warp.h. All densities are per unit solid angle, and 0 for
// directions with z <= 0.

#pragma once

#include "wellstrat/warp/cap.h"
#include "wellstrat/warp/disk.h"

namespace wellstrat {

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

/// A vector with z > 0, scaled to length 1.
WELLSTRAT_HOST_DEVICE inline Float3 normalized(Float3 v) { return v / v.Length(); }

} // namespace detail

/// A microfacet normal m with z > 0, distributed as the GGX normals of roughness (alphaX, alphaY)
/// that `view` sees. The roughness is that of the distribution, above 0, and not its square root;
/// `view` has length 1, points away from the surface, and has z > 0. Normals may face away from it
/// by rounding only. Reflecting `view` at m gives a direction of density
/// ggxVisibleNormalPdf / (4 Dot(view, m)), which may lie below the surface.
///
/// In the space where the microsurface is a hemisphere, the reflected directions are uniform on a
/// cap of the sphere: Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps",
/// section 3. The older map through a disk (Heitz 2018, JCGT 7(4)) takes more operations.
WELLSTRAT_HOST_DEVICE inline Float3 squareToGgxVisibleNormal(Float2 xi, Float3 view, float alphaX,
                                                             float alphaY) {
    const Float3 v = detail::normalized({alphaX * view.x, alphaY * view.y, view.z});
    const Float3 reflected = squareToCone(xi, -v.z);
    // reflected.z + v.z, without cancellation: above 0 for all samples.
    const float z = (1.0f - xi.x) * (1.0f + v.z);
    return detail::normalized({alphaX * (reflected.x + v.x), alphaY * (reflected.y + v.y), z});
}

/// Dot(view, m) > 0.
WELLSTRAT_HOST_DEVICE inline Float2 ggxVisibleNormalToSquare(Float3 m, Float3 view, float alphaX,
                                                             float alphaY) {
    const Float3 v = detail::normalized({alphaX * view.x, alphaY * view.y, view.z});
    const Float3 h = detail::normalized({m.x / alphaX, m.y / alphaY, m.z});
    return coneToSquare(h * (2.0f * Dot(h, v)) - v, -v.z);
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

} // namespace wellstrat
