// SPDX-License-Identifier: Apache-2.0
//
// Fresnel's equations: the share of unpolarized light that a smooth surface reflects. For
// transparent media Born and Wolf 1999, "Principles of Optics", 7th edition, section 1.5.2; for
// metals the same equations with a complex refractive index, section 14.2.
//
// `cosine`, in [-1, 1], is that of the angle between the normal and the light; its sign, the side
// of the normal, does not matter, nor that rounding takes it a little above 1. The share is in [0,
// 1], 1 at grazing angles, and exact to about 1e-6. A NaN gives a NaN. The functions are pure,
// check nothing and may run in any thread.

#pragma once

#include "wellstrat/vector.h"

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// |p - q|^2 / |p + q|^2 of p + i 0 and q.x + i q.y: the power of an amplitude (p - q) / (p + q).
/// 1 where p + q is 0, which happens in the limit of grazing light only.
WELLSTRAT_HOST_DEVICE constexpr float reflectedPower(float p, Float2 q) {
    const float reflected = (p - q.x) * (p - q.x) + q.y * q.y;
    const float arriving = (p + q.x) * (p + q.x) + q.y * q.y;
    return arriving == 0.0f ? 1.0f : reflected / arriving;
}

} // namespace detail

/// The boundary of two transparent media. `eta`, above 0, is the refractive index where the light
/// comes from over the one behind the boundary: 1 / 1.5 from air into glass, 1.5 from glass into
/// air. Beyond the critical angle, where the sine is 1 / eta, all light is reflected.
WELLSTRAT_HOST_DEVICE inline float fresnelDielectric(float cosine, float eta) {
    const float c = detail::copySign(cosine, 1.0f);
    // The squared cosine behind the boundary, 1 - (eta s)^2, with the terms that cancel least.
    const float behindSquared = c * c < 0.5f ? (1.0f - eta) * (1.0f + eta) + eta * c * (eta * c)
                                             : 1.0f - eta * eta * (1.0f - c) * (1.0f + c);
    if (behindSquared <= 0.0f) return 1.0f;
    const float behind = detail::squareRoot(behindSquared);
    const float perpendicular = detail::reflectedPower(eta * c, {behind, 0.0f});
    const float parallel = detail::reflectedPower(c, {eta * behind, 0.0f});
    return 0.5f * (perpendicular + parallel);
}

/// The surface of a metal of complex refractive index eta + i kappa, both over the index of the
/// transparent medium before it. `eta` and `kappa` are in [0, 1e9]; kappa absorbs. With kappa = 0
/// it is fresnelDielectric(cosine, 1 / eta).
WELLSTRAT_HOST_DEVICE inline float fresnelConductor(float cosine, float eta, float kappa) {
    const float c = detail::copySign(cosine, 1.0f);
    const float sineSquared = c < 1.0f ? (1.0f - c) * (1.0f + c) : 0.0f;

    // a + i b, the root of (eta + i kappa)^2 - sineSquared. The larger part is the root of a sum,
    // and the smaller follows from their product, so that little cancels.
    const float real = (c * c < 0.5f ? (eta - 1.0f) * (eta + 1.0f) + c * c //
                                     : eta * eta - sineSquared) -
                       kappa * kappa;
    const float product = eta * kappa;
    const float modulus = detail::squareRoot(real * real + 4.0f * product * product);
    const float larger = detail::squareRoot(0.5f * (modulus + detail::copySign(real, 1.0f)));
    const float smaller = larger > 0.0f ? product / larger : 0.0f;
    const float a = real < 0.0f ? smaller : larger;
    const float b = real < 0.0f ? larger : smaller;

    const float perpendicular = detail::reflectedPower(c, {a, b});
    const float quotient = detail::reflectedPower(sineSquared, {a * c, b * c});
    return 0.5f * perpendicular * (1.0f + quotient); // the parallel share is their product
}

} // namespace stream1
} // namespace wellstrat
