// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's materials to ours.

#pragma once

#include "../scene.h"
#include "notes.h"
#include "scene_textures.h"

#include <assimp/material.h>

namespace wellstrat::render {

/// A material, and which of a mesh's sets of texture coordinates it uses.
struct ImportedMaterial {
    Material material;
    unsigned uvSet = 0;
};

/// Metallic-roughness materials are taken as they are. Those of older formats, such as MTL, have a
/// diffuse and a specular color and Phong's exponent n: alpha of GGX is sqrt(2 / (n + 2)) (Walter
/// et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", section 5.2), and
/// specularF0 is 0.08 times the specular color, as in Burley 2012, "Physically-Based Shading at
/// Disney"; with a black diffuse color they are metals of the specular color. Where the
/// format cannot say whether a surface emits on both sides, as MTL, it does. Numbers outside their
/// range are clamped, with a note.
ImportedMaterial importMaterial(const aiMaterial& source, SceneTextures& textures, Notes& notes);

} // namespace wellstrat::render
