// SPDX-License-Identifier: Apache-2.0
//
// What a hit point reflects, by one sample of each of two domains. Kernels of GPUs may call it.

#pragma once

#include "RixShadingUtils.h"
#include "scene.h"
#include "wellstrat/domain.h"

namespace area_light {

// Any two different constants will do.
constexpr auto kBxdfScramble = static_cast<wellstrat::Scramble>(0x6b8f21d3);
constexpr auto kLightScramble = static_cast<wellstrat::Scramble>(0x91e4c05a);

/// Light that the hit point reflects of one point of the light, over the density of that point.
WELLSTRAT_HOST_DEVICE inline RtFloat3 lightEstimate(const Hit& hit, RtFloat2 xi) {
    const LightPoint point = lightPoint(xi);
    RtVector3 direction = point.position - hit.position;
    const float distance = direction.Normalize();
    const float cosSurface = direction.Dot(hit.normal);
    const float cosLight = -direction.Dot(point.normal);
    if (cosSurface <= 0.0f || cosLight <= 0.0f || blocked({hit.position, direction}, distance)) {
        return RtFloat3(0.0f);
    }
    return lightRadiance() * (F_INVPI * cosSurface * cosLight * kLightArea / (distance * distance));
}

/// Light that it reflects of the sky, from a direction in proportion to the cosine.
WELLSTRAT_HOST_DEVICE inline RtFloat3 skyEstimate(const Hit& hit, RtFloat2 xi) {
    RtVector3 direction;
    float cosine;
    RixCosDirectionalDistribution(xi, hit.normal, direction, cosine);
    return skyRadiance({hit.position, direction});
}

} // namespace area_light
