// SPDX-License-Identifier: Apache-2.0
//
// What light goes through: air, which takes nothing away, or a solid body that absorbs a part of it
// on its way (Lambert and Beer's law; glTF's KHR_materials_volume).

#pragma once

#include "color.h"
#include "scene.h"

#include <cmath>

namespace wellstrat::render {

/// The material of a body; null: air.
using MediumPtr = const Material*;

/// What is behind the surface of a body, seen from this side. Bodies are in air.
inline MediumPtr mediumBehind(const Material& solid, bool fromOutside) {
    return fromOutside && !isBlack(solid.absorption) ? &solid : nullptr;
}

/// Which part of the light is left after a distance above 0. All of it if there is no end: what
/// leads out of a mesh with holes counts as air.
inline Float3 transmittance(const Material& solid, float distance) {
    if (std::isinf(distance)) return Float3(1.0f);
    const Float3 depth = solid.absorption * -distance;
    return {std::exp(depth.x), std::exp(depth.y), std::exp(depth.z)};
}

} // namespace wellstrat::render
