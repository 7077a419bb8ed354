// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's lights and cameras to ours.

#pragma once

#include "../scene.h"
#include "notes.h"

#include <assimp/scene.h>

namespace wellstrat::render {

/// The punctual lights. Lights whose light falls off with the square of the distance have their
/// color divided by its factor. Others and those that are no numbers are left out, with a note.
std::vector<PunctualLight> importLights(const aiScene& scene, Notes& notes);

/// The cameras. Those that are not perspective are left out, with a note.
std::vector<NamedCamera> importCameras(const aiScene& scene, Notes& notes);

} // namespace wellstrat::render
