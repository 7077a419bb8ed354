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

/// Metallic-roughness materials are taken as they are, others by `makePhong`. Where the format
/// cannot say whether a surface emits on both sides, it does. Numbers outside their range are
/// clamped, with a note.
ImportedMaterial importMaterial(const aiMaterial& source, SceneTextures& textures, Notes& notes);

} // namespace wellstrat::render
