// SPDX-License-Identifier: Apache-2.0
//
// What sampling code of Bxdfs, lights and integrators needs besides the samples: choosing among
// lobes or lights, and directions around a normal. More maps are in wellstrat/warp.h.

#pragma once

#include "RiTypesHelper.h"
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
constexpr RtFloat F_PIDIV2 = 0.5f * F_PI;
constexpr RtFloat F_PIDIV4 = 0.25f * F_PI;
constexpr RtFloat F_INVPI = wellstrat::detail::kInvPi;
constexpr RtFloat F_INVTWOPI = wellstrat::detail::kInvTwoPi;
constexpr RtFloat F_INVFOURPI = wellstrat::detail::kInvFourPi;

template <class T>
constexpr T RixMin(T a, T b) {
    return b < a ? b : a;
}
template <class T>
constexpr T RixMax(T a, T b) {
    return a < b ? b : a;
}

/// The sine and cosine of an angle in radians.
PRMAN_INLINE void RixSinCos(RtFloat angle, RtFloat* sine, RtFloat* cosine) {
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
PRMAN_INLINE unsigned RixChooseAndRemap(float& xi, float prob0) {
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
PRMAN_INLINE unsigned RixChooseAndRemap(float& xi, const float* weights, unsigned n,
                                        float* prob = nullptr) {
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

/// The vector with coordinates `local` along the three axes.
PRMAN_INLINE RtVector3 RixChangeBasisFrom(RtVector3 const& local, RtVector3 const& axisX,
                                          RtVector3 const& axisY, RtVector3 const& axisZ) {
    return axisX * local.x + axisY * local.y + axisZ * local.z;
}

/// The normal turned to the side that `view` is on, and the cosine between the two, at least 0.
PRMAN_INLINE RtNormal3 RixGetForwardFacingNormal(RtVector3 const& view, RtNormal3 const& normal,
                                                 RtFloat* cosView = nullptr) {
    const RtFloat cosine = Dot(view, normal);
    if (cosView) *cosView = std::fabs(cosine);
    return cosine < 0.0f ? -normal : normal;
}

/// The mirror image of `view` about `normal`; both and the result point away from the surface.
PRMAN_INLINE RtVector3 RixReflect(RtVector3 const& view, RtNormal3 const& normal) {
    return normal * (2.0f * Dot(view, normal)) - view;
}

/// A direction around `normal`, with probability proportional to the cosine between them:
/// cosTheta, in (0, 1]. Its density is cosTheta * F_INVPI per unit solid angle. `normal` has
/// length 1; it and the tangents form an orthonormal frame, made from the normal if left out.
PRMAN_INLINE void RixCosDirectionalDistribution(RtFloat2 const& xi, RtNormal3 const& normal,
                                                RtVector3 const& tangent,
                                                RtVector3 const& bitangent, RtVector3& direction,
                                                RtFloat& cosTheta) {
    const RtVector3 local = wellstrat::squareToHemisphereCosine(xi);
    direction = RixChangeBasisFrom(local, tangent, bitangent, normal);
    cosTheta = local.z;
}
PRMAN_INLINE void RixCosDirectionalDistribution(RtFloat2 const& xi, RtNormal3 const& normal,
                                                RtVector3& direction, RtFloat& cosTheta) {
    RtVector3 tangent, bitangent;
    normal.CreateOrthonormalBasis(tangent, bitangent);
    RixCosDirectionalDistribution(xi, normal, tangent, bitangent, direction, cosTheta);
}

/// The same with equal probability over the hemisphere: density F_INVTWOPI. cosTheta is xi.y (at
/// least 2^-24) and the azimuth xi.x, so a caller that shapes xi.y shapes the cosine.
PRMAN_INLINE void RixUniformDirectionalDistribution(RtFloat2 const& xi, RtNormal3 const& normal,
                                                    RtVector3 const& tangent,
                                                    RtVector3 const& bitangent,
                                                    RtVector3& direction, RtFloat& cosTheta) {
    const RtVector3 local = wellstrat::squareToHemisphere({1.0f - RixMax(xi.y, 0x1p-24f), xi.x});
    direction = RixChangeBasisFrom(local, tangent, bitangent, normal);
    cosTheta = local.z;
}
PRMAN_INLINE void RixUniformDirectionalDistribution(RtFloat2 const& xi, RtNormal3 const& normal,
                                                    RtVector3& direction, RtFloat& cosTheta) {
    RtVector3 tangent, bitangent;
    normal.CreateOrthonormalBasis(tangent, bitangent);
    RixUniformDirectionalDistribution(xi, normal, tangent, bitangent, direction, cosTheta);
}
