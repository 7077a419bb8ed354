// SPDX-License-Identifier: Apache-2.0
//
// Light that surfaces give off by themselves.

#pragma once

#include "color.h"
#include "scene.h"

namespace wellstrat::render {

inline bool emits(const Material& material) { return largestChannel(material.emission) > 0.0f; }

/// The radiance that leaves a point of a surface towards `direction`.
inline Float3 emittedRadiance(const Material& material, const SurfaceAttributes& attributes,
                              Float3 geometricNormal, Float3 direction) {
    if (!material.doubleSided && !(Dot(geometricNormal, direction) > 0.0f)) return Float3(0.0f);
    Float3 radiance = material.emission;
    if (material.emissionTexture)
        radiance = multiply(radiance, material.emissionTexture.lookup(attributes));
    return material.colorIsEmission ? multiply(radiance, attributes.color) : radiance;
}

} // namespace wellstrat::render
