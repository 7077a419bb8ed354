// SPDX-License-Identifier: Apache-2.0
//
// From the materials of glTF to ours.

#pragma once

#include "../../scene.h"
#include "../notes.h"
#include "textures.h"

#include <tiny_gltf.h>

#include <array>
#include <string>

namespace wellstrat::render {

/// A material, and which sets of texture coordinates of a mesh its first and second are; -1: none.
struct GltfMaterial {
    Material material;
    std::array<int, 2> uvSets{-1, -1};
};

/// Metallic-roughness materials are taken as they are, with KHR_materials_ior, _specular,
/// _emissive_strength, _transmission and _volume: where that gives a thickness, whichever, the mesh
/// is the boundary of a body, whose shape says how thick it is. Of
/// KHR_materials_pbrSpecularGlossiness, the specular color is that of a non-metal, and its diffuse
/// lobe loses what that reflects. Surfaces of KHR_materials_unlit give off their color as light,
/// and reflect none. KHR_texture_transform maps
///
///     u' = offset.x + scale.x cos(rotation) u + scale.y sin(rotation) v
///     v' = offset.y - scale.x sin(rotation) u + scale.y cos(rotation) v
///
/// which turns counterclockwise where v goes down, as the text of its specification and its two
/// examples have it, and as its test models and the common viewers do; the listing in GLSL beside
/// the text, read by columns, turns the other way: https://github.com/KhronosGroup/glTF/issues/1563
/// Numbers outside their range are clamped, with a note.
GltfMaterial importMaterial(const tinygltf::Material& source, GltfTextures& textures, Notes& notes);

} // namespace wellstrat::render
