// SPDX-License-Identifier: Apache-2.0
//
// Scenes of glTF 2.0.

#pragma once

#include "../../scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// As `importScene` says.
Scene importGltf(const std::string& path, uint64_t mostTriangles);

} // namespace wellstrat::render
