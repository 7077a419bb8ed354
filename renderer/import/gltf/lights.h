// SPDX-License-Identifier: Apache-2.0
//
// The lights of glTF: KHR_lights_punctual.

#pragma once

#include "../../scene.h"
#include "../notes.h"
#include "nodes.h"

#include <vector>

namespace wellstrat::render {

/// The punctual lights of a scene. Intensities are taken as they are: candela as W / sr, lux as
/// W / m^2, just as its emitted colors in cd / m^2 are taken as W / (m^2 sr), so that lights keep
/// their proportions. Those that are no numbers are left out, with a note.
std::vector<PunctualLight> importLights(const GltfDocument& document,
                                        const std::vector<GltfInstance>& lights, Notes& notes);

} // namespace wellstrat::render
