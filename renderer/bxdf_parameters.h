// SPDX-License-Identifier: Apache-2.0
//
// What a material is at a point of a surface, with its textures looked up and all numbers in range.

#pragma once

#include "scene.h"

#include "wellstrat/vector.h"

namespace wellstrat::render {

struct BxdfParameters {
    Float3 diffuseColor; ///< what the diffuse lobe makes of the light that enters
    float diffuseScale;  ///< 1 / (pi (1 - mean reflection of the dielectric))
    float dielectricF0;  ///< reflection at normal incidence of the part that is no metal
    Float3 f0;           ///< of all of it; of the metal alone where light passes
    float alpha;         ///< of GGX

    // Where light passes:
    Float3 passingColor;  ///< of it; black: none passes
    float ior = 0;        ///< index of refraction over that of air; 0: no light passes
    float metallic = 0;   ///< the part that is metal
    bool isSolid = false; ///< it is refracted; else it goes straight on
};

/// All finite for finite material parameters, which count as clamped to their range.
BxdfParameters bxdfParameters(const Material& material, const SurfaceAttributes& attributes);

} // namespace wellstrat::render
