// SPDX-License-Identifier: Apache-2.0
//
// Light for scenes that bring none, or none that shows them.

#pragma once

#include "scene.h"

namespace wellstrat::render {

/// The light of a photographer's studio, neutral gray in all its parts: a sky that is brighter
/// above, ground of middle gray, and a large key light from above, behind the left shoulder of who
/// looks along `forward`. It makes a white surface 0.2 to 0.9 bright.
Environment studio(Float3 forward);

/// Which part of the surfaces that `scene.camera` sees has a luminance above kLitLuminance by the
/// light that the scene brings, in a picture of this width / height: 0 without any light, 1 if no
/// surface is seen. An estimate from some ten thousand paths, always the same. The scene must be
/// one that can be rendered.
double litShare(const Scene& scene, float aspect);

constexpr float kLitLuminance = 1 / 256.0f; ///< darker things are black to the eye
constexpr double kLeastLit = 0.1;           ///< scenes whose share is below this want a studio

} // namespace wellstrat::render
