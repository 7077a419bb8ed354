// SPDX-License-Identifier: Apache-2.0
//
// What the sampling and shading code of Bxdfs, lights and integrators needs besides the samples:
// small arithmetic, choosing among lobes or lights, frames and directions around a normal,
// Fresnel's equations. More maps are in wellstrat/warp.h. Vectors that are called directions,
// normals or axes have length 1; everything is pure and may run in any thread, of a GPU too.

#pragma once

#include "RiTypesHelper.h"
#include "wellstrat/fresnel.h"
#include "wellstrat/warp.h"

#if defined(_WIN32)
#include <malloc.h>
#else
#include <alloca.h>
#endif

/// Uninitialized memory on the stack until the calling function returns, aligned for any type of
/// this interface. For the few kilobytes of a batch: too much overflows the stack.
#define RixAlloca(bytes) alloca(bytes)

constexpr RtFloat F_PI = wellstrat::detail::kPi;
constexpr RtFloat F_TWOPI = wellstrat::detail::kTwoPi;
constexpr RtFloat F_FOURPI = 2.0f * F_TWOPI;
constexpr RtFloat F_PIDIV2 = 0.5f * F_PI;
constexpr RtFloat F_PIDIV4 = 0.25f * F_PI;
constexpr RtFloat F_INVPI = wellstrat::detail::kInvPi;
constexpr RtFloat F_INVTWOPI = wellstrat::detail::kInvTwoPi;
constexpr RtFloat F_INVFOURPI = wellstrat::detail::kInvFourPi;

template <class T>
WELLSTRAT_HOST_DEVICE constexpr T RixMin(T a, T b) {
    return b < a ? b : a;
}
template <class T>
WELLSTRAT_HOST_DEVICE constexpr T RixMax(T a, T b) {
    return a < b ? b : a;
}

/// x moved into [low, high]; low <= high. NaN stays NaN.
template <class T>
WELLSTRAT_HOST_DEVICE constexpr T RixClamp(T x, T low, T high) {
    return RixMin(RixMax(x, low), high);
}

/// (1 - t) a + t b, of floats, colors or vectors: exactly a for t = 0 and b for t = 1. Any t.
template <class T>
WELLSTRAT_HOST_DEVICE constexpr T RixMix(T const& a, T const& b, RtFloat t) {
    return a * (1.0f - t) + b * t;
}

WELLSTRAT_HOST_DEVICE constexpr RtFloat RixDegreesToRadians(RtFloat degrees) {
    return degrees * (F_PI / 180.0f);
}

/// The sine and cosine of an angle in radians.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE void RixSinCos(RtFloat angle, RtFloat* sine, RtFloat* cosine) {
    *sine = std::sin(angle);
    *cosine = std::cos(angle);
}

/// Returns 0 with probability prob0 and 1 otherwise, and stretches the part of [0, 1) that was
/// chosen back over [0, 1), so that xi can be used again; a set of stratified samples gives
/// stratified subsets. Shirley et al. 1996, "Monte Carlo Techniques for Direct Lighting
/// Calculations", ACM TOG 15(1).
///
/// xi is in [0, 1) before and after, never 1. An outcome of probability 0 never comes. prob0 below
/// 0, or NaN, counts as 0; above 1 as 1. A choice of probability p leaves the sample with
/// log2(1 / p) fewer of its 24 random bits.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE unsigned RixChooseAndRemap(float& xi, float prob0) {
    const double position = wellstrat::detail::clampToUnit(xi);
    const double width = prob0 > 0.0f ? RixMin(prob0, 1.0f) : 0.0f;
    const bool first = position < width;
    const double stretched = first ? position / width : (position - width) / (1.0 - width);
    xi = wellstrat::detail::clampToUnit(static_cast<float>(stretched));
    return first ? 0 : 1;
}

/// Returns i in [0, n) with probability weights[i] / (sum of weights), written to *prob if prob is
/// not null, and stretches xi as above. Takes time proportional to n.
///
/// Weights are finite and need no normalization. A weight that is 0, negative or NaN is never
/// chosen. If no weight is above 0, or n is 0, returns n, with probability 0 and xi as it was.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE unsigned RixChooseAndRemap(float& xi, const float* weights,
                                                              unsigned n, float* prob = nullptr) {
    double total = 0.0;
    for (unsigned i = 0; i < n; ++i) total += RixMax(0.0f, weights[i]);

    const double position = wellstrat::detail::clampToUnit(xi) * total;
    unsigned chosen = n;
    double begin = 0.0;
    double end = 0.0;
    for (unsigned i = 0; i < n && !(position < end); ++i) {
        if (!(weights[i] > 0.0f)) continue;
        chosen = i;
        begin = end;
        end += weights[i];
    }
    const bool found = chosen < n;
    if (found) {
        const double stretched = (position - begin) / weights[chosen];
        xi = wellstrat::detail::clampToUnit(static_cast<float>(stretched));
    }
    if (prob) *prob = found ? static_cast<float>(weights[chosen] / total) : 0.0f;
    return chosen;
}

/// An orthonormal right-handed frame (axisX, axisY, normal) whose axisX is `tangent`, turned into
/// the plane of the surface. The tangent is of any length from 1e-15 to 1e15. Where it is 0, NaN or
/// within 1e-6 radians of the normal, the frame is that of CreateOrthonormalBasis. `tangent` may be
/// `axisX`.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE void RixComputeShadingBasis(RtNormal3 const& normal,
                                                               RtVector3 const& tangent,
                                                               RtVector3& axisX, RtVector3& axisY) {
    RtVector3 x = tangent - normal * Dot(normal, tangent);
    if (x.LengthSq() > 1e-12f * tangent.LengthSq()) {
        x.Normalize();
        x -= normal * Dot(normal, x); // what cancelled when the tangent was almost the normal
        x.Normalize();
        axisX = x;
        axisY = Cross(normal, x);
    } else {
        normal.CreateOrthonormalBasis(axisX, axisY);
    }
}

/// The coordinates of `vector` along the three axes: the inverse of RixChangeBasisFrom.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtVector3 RixChangeBasisTo(RtVector3 const& vector,
                                                              RtVector3 const& axisX,
                                                              RtVector3 const& axisY,
                                                              RtVector3 const& axisZ) {
    return {Dot(vector, axisX), Dot(vector, axisY), Dot(vector, axisZ)};
}

/// The vector with coordinates `local` along the three axes.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtVector3 RixChangeBasisFrom(RtVector3 const& local,
                                                                RtVector3 const& axisX,
                                                                RtVector3 const& axisY,
                                                                RtVector3 const& axisZ) {
    return axisX * local.x + axisY * local.y + axisZ * local.z;
}

/// The direction at the polar angle theta from z and the azimuth phi, in radians from x towards y;
/// of the coordinate axes, or of the given ones.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtVector3 RixSphericalDirection(RtFloat sinTheta,
                                                                   RtFloat cosTheta, RtFloat phi) {
    RtFloat sinPhi, cosPhi;
    RixSinCos(phi, &sinPhi, &cosPhi);
    return {sinTheta * cosPhi, sinTheta * sinPhi, cosTheta};
}
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtVector3 RixSphericalDirection(RtFloat sinTheta,
                                                                   RtFloat cosTheta, RtFloat phi,
                                                                   RtVector3 const& axisX,
                                                                   RtVector3 const& axisY,
                                                                   RtVector3 const& axisZ) {
    return RixChangeBasisFrom(RixSphericalDirection(sinTheta, cosTheta, phi), axisX, axisY, axisZ);
}

/// The normal turned to the side that `view` is on, and the cosine between the two, at least 0.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtNormal3 RixGetForwardFacingNormal(RtVector3 const& view,
                                                                       RtNormal3 const& normal,
                                                                       RtFloat* cosView = nullptr) {
    const RtFloat cosine = Dot(view, normal);
    if (cosView) *cosView = std::fabs(cosine);
    return cosine < 0.0f ? -normal : normal;
}

/// The normal turned away from `view`, and the cosine between the two, at most 0.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtNormal3 RixGetBackwardFacingNormal(
    RtVector3 const& view, RtNormal3 const& normal, RtFloat* cosView = nullptr) {
    const RtNormal3 forward = RixGetForwardFacingNormal(view, normal, cosView);
    if (cosView) *cosView = -*cosView;
    return -forward;
}

/// The mirror image of `view` about `normal`; both and the result point away from the surface.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtVector3 RixReflect(RtVector3 const& view,
                                                        RtNormal3 const& normal) {
    return normal * (2.0f * Dot(view, normal)) - view;
}

/// A direction around `normal`, with probability proportional to the cosine between them:
/// cosTheta, in (0, 1]. Its density is cosTheta * F_INVPI per unit solid angle. `normal` has
/// length 1; it and the tangents form an orthonormal frame, made from the normal if left out.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE void
RixCosDirectionalDistribution(RtFloat2 const& xi, RtNormal3 const& normal, RtVector3 const& tangent,
                              RtVector3 const& bitangent, RtVector3& direction, RtFloat& cosTheta) {
    const RtVector3 local = wellstrat::squareToHemisphereCosine(xi);
    direction = RixChangeBasisFrom(local, tangent, bitangent, normal);
    cosTheta = local.z;
}
WELLSTRAT_HOST_DEVICE PRMAN_INLINE void RixCosDirectionalDistribution(RtFloat2 const& xi,
                                                                      RtNormal3 const& normal,
                                                                      RtVector3& direction,
                                                                      RtFloat& cosTheta) {
    RtVector3 tangent, bitangent;
    normal.CreateOrthonormalBasis(tangent, bitangent);
    RixCosDirectionalDistribution(xi, normal, tangent, bitangent, direction, cosTheta);
}

/// The same with equal probability over the hemisphere: density F_INVTWOPI. cosTheta is xi.y (at
/// least 2^-24) and the azimuth xi.x, so a caller that shapes xi.y shapes the cosine.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE void
RixUniformDirectionalDistribution(RtFloat2 const& xi, RtNormal3 const& normal,
                                  RtVector3 const& tangent, RtVector3 const& bitangent,
                                  RtVector3& direction, RtFloat& cosTheta) {
    const RtVector3 local = wellstrat::squareToHemisphere({1.0f - RixMax(xi.y, 0x1p-24f), xi.x});
    direction = RixChangeBasisFrom(local, tangent, bitangent, normal);
    cosTheta = local.z;
}
WELLSTRAT_HOST_DEVICE PRMAN_INLINE void RixUniformDirectionalDistribution(RtFloat2 const& xi,
                                                                          RtNormal3 const& normal,
                                                                          RtVector3& direction,
                                                                          RtFloat& cosTheta) {
    RtVector3 tangent, bitangent;
    normal.CreateOrthonormalBasis(tangent, bitangent);
    RixUniformDirectionalDistribution(xi, normal, tangent, bitangent, direction, cosTheta);
}

/// The share of unpolarized light that the boundary of two transparent media reflects, in [0, 1]:
/// wellstrat::fresnelDielectric. `cosine` is that of the angle between the light, or the viewer,
/// and the normal, of either sign. `eta` is the refractive index on their side over that on the
/// other, as in RSL's fresnel(): 1 / 1.5 for a viewer in air before glass. Returned, and written to
/// *reflected if that is not null.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtFloat RixFresnelDielectric(RtFloat cosine, RtFloat eta,
                                                                RtFloat* reflected = nullptr) {
    const RtFloat share = wellstrat::fresnelDielectric(cosine, eta);
    if (reflected) *reflected = share;
    return share;
}

/// The same of a metal of refractive index eta + i kappa, over that of the medium before it:
/// wellstrat::fresnelConductor. At right angles ((eta - 1)^2 + kappa^2) / ((eta + 1)^2 + kappa^2).
/// Colors have an index for each channel.
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtFloat RixFresnelConductor(RtFloat cosine, RtFloat eta,
                                                               RtFloat kappa,
                                                               RtFloat* reflected = nullptr) {
    const RtFloat share = wellstrat::fresnelConductor(cosine, eta, kappa);
    if (reflected) *reflected = share;
    return share;
}
WELLSTRAT_HOST_DEVICE PRMAN_INLINE RtColorRGB RixFresnelConductor(RtFloat cosine,
                                                                  RtColorRGB const& eta,
                                                                  RtColorRGB const& kappa,
                                                                  RtColorRGB* reflected = nullptr) {
    const RtColorRGB share(RixFresnelConductor(cosine, eta.r, kappa.r),
                           RixFresnelConductor(cosine, eta.g, kappa.g),
                           RixFresnelConductor(cosine, eta.b, kappa.b));
    if (reflected) *reflected = share;
    return share;
}
