// SPDX-License-Identifier: Apache-2.0
//
// How bright lights are as a whole: their luminous power, which decides how often each is chosen.

#pragma once

#include "scene.h"

namespace wellstrat::render {

/// Of a triangle at the opening of the shutter. With a texture, an estimate from a few points.
double trianglePower(const Mesh& mesh, uint32_t primitive, const Material& material);

double spherePower(const Sphere& sphere, const Material& material);

/// `sceneRadius` is of a sphere around the scene, of which a directional light lights all.
double punctualPower(const PunctualLight& light, float sceneRadius);

} // namespace wellstrat::render
