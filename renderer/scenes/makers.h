// SPDX-License-Identifier: Apache-2.0
//
// One function for each built-in scene, in the file of its name.

#pragma once

#include "../scene.h"

namespace wellstrat::render {

Scene cornellScene();
Scene lensScene();
Scene manyLightsScene();
Scene sphereLightScene();
Scene veachScene();

} // namespace wellstrat::render
