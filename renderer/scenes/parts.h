// SPDX-License-Identifier: Apache-2.0
//
// What the built-in scenes are made of.

#pragma once

#include "../scene.h"

#include <array>

namespace wellstrat::render {

using Quad = std::array<Float3, 4>; ///< convex, counterclockwise as seen from its front

constexpr float radians(float degrees) { return degrees * (3.14159265f / 180.0f); }

/// Adds a material and returns its index.
uint32_t addMaterial(Scene& scene, const Material& material);

/// An ideal Lambertian surface.
Material lambertian(Float3 color);

/// A light that reflects nothing.
Material emitter(Float3 radiance);

/// Adds quadrilaterals as one mesh with flat normals. Texture coordinates run over each from
/// (0, 0) at its first corner to (1, 1) at its third.
void addQuads(Scene& scene, const std::vector<Quad>& quads, uint32_t material);

/// The rectangle center +- u +- v, its front on the side of u x v.
Quad rectangle(Float3 center, Float3 u, Float3 v);

/// The six sides of the box center +- u +- v +- w, their fronts outside. u, v, w are right-handed.
std::vector<Quad> box(Float3 center, Float3 u, Float3 v, Float3 w);

/// A texture of two alternating colors, cells x cells, each size x size pixels.
TexturePtr checkerboard(unsigned cells, unsigned size, Float3 even, Float3 odd);

} // namespace wellstrat::render
