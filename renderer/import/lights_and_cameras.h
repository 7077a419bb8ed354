// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's lights and cameras to ours.

#pragma once

#include "../scene.h"
#include "notes.h"

#include <assimp/scene.h>

namespace wellstrat::render {

/// The punctual lights. Intensities are taken as they are: candela of glTF as W / sr, lux as
/// W / m^2, just as its emitted colors in cd / m^2 are taken as W / (m^2 sr), so that lights keep
/// their proportions. Lights of other formats whose light falls off with the square of the distance
/// have their color divided by its factor. Others and those that are no numbers are left out, with
/// a note.
std::vector<PunctualLight> importLights(const aiScene& scene, Notes& notes);

/// The first camera and the width / height it was made for (1 if it does not say), if there is a
/// perspective one.
struct ImportedCamera {
    Camera camera;
    float aspect;
};
std::optional<ImportedCamera> importCamera(const aiScene& scene, Notes& notes);

} // namespace wellstrat::render
