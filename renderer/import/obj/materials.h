// SPDX-License-Identifier: Apache-2.0
//
// From the materials of MTL files to ours.

#pragma once

#include "../../scene.h"
#include "../file_textures.h"
#include "../notes.h"
#include "mtl_file.h"

#include <string>

namespace wellstrat::render {

/// With a roughness or metallicity, a metallic-roughness material, whose index of refraction
/// counts; otherwise `makePhong`'s. Without a color, one that has a picture is white and others are
/// light gray. Opacities below 1 and pictures of them blend; what such a picture says is its alpha
/// if it has any, or else its gray. Where the model of illumination is one of glass (4, 9) or of
/// refraction (6, 7) and there is no such picture, light passes instead, in the color "Tf", unless
/// that is black: the part 1 - d straight on through thin sheets of glass, and what a body refracts
/// by "Ni", the same part, or all where d is 1, as their equations do not know it. These are smooth
/// unless they have a roughness. Textures are scaled before they are offset, from the lower left
/// corner, and the border of clamped ones goes on. Surfaces emit on both sides: the format cannot
/// say. Numbers outside their range are clamped, with a note.
Material importMaterial(const MtlMaterial& source, FileTextures& textures, Notes& notes);

} // namespace wellstrat::render
