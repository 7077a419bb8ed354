// SPDX-License-Identifier: Apache-2.0
//
// What a scene must be to be rendered.

#pragma once

#include "scene.h"

namespace wellstrat::render {

/// Throws std::invalid_argument, with one line, for a scene without a camera, and for one that
/// breaks what scene.h promises of numbers and lengths of arrays.
void checkScene(const Scene& scene);

/// The same for a camera.
void checkCamera(const Camera& camera);

} // namespace wellstrat::render
