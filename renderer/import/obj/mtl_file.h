// SPDX-License-Identifier: Apache-2.0
//
// What an MTL file says: Wavefront's "MTL material format", http://paulbourke.net/dataformats/mtl/,
// and the statements of exocortex.com/blog/extending_wavefront_mtl_to_support_pbr.

#pragma once

#include "../notes.h"

#include "wellstrat/vector.h"

#include <optional>
#include <string>
#include <vector>

namespace wellstrat::render {

/// A picture and its options.
struct MtlMap {
    std::string file; ///< empty: none
    Float2 scale{1, 1}, offset{0, 0};
    bool isClamped = false;
    float bumpFactor = 1;
};

/// What is not there was not said.
struct MtlMaterial {
    std::string name;
    float illumination = 0;                            ///< illum, the number of a model
    std::optional<Float3> diffuse, specular, emission; ///< Kd, Ks, Ke
    std::optional<Float3> filter;                      ///< Tf
    std::optional<float> phongExponent;                ///< Ns
    std::optional<float> indexOfRefraction;            ///< Ni
    std::optional<float> opacity;                      ///< d, or 1 - Tr
    std::optional<float> roughness, metallic;          ///< Pr, Pm
    MtlMap diffuseMap, emissionMap, opacityMap, roughnessMap, metallicMap, normalMap;
};

/// The materials of a file, in its order. Any text gives some; a note says what of it changes
/// pictures and is left out.
std::vector<MtlMaterial> parseMtl(std::string text, Notes& notes);

} // namespace wellstrat::render
