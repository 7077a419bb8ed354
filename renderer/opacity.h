// SPDX-License-Identifier: Apache-2.0
//
// Which part of a surface is there.

#pragma once

#include "color.h"
#include "scene.h"

namespace wellstrat::render {

/// From 0, where all light passes straight on, to 1: glTF 2.0 specification, section 3.9.4, "Alpha
/// Coverage".
inline float opacityAt(const Material& material, const SurfaceAttributes& attributes) {
    if (material.alpha == Material::Alpha::opaque) return 1.0f;
    float opacity = material.opacity * attributes.opacity;
    if (material.opacityTexture) opacity *= material.opacityTexture.lookup(attributes).x;
    if (material.alpha == Material::Alpha::blend) return clamp01(opacity);
    return opacity >= material.opacityCutoff ? 1.0f : 0.0f;
}

} // namespace wellstrat::render
