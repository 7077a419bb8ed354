// SPDX-License-Identifier: Apache-2.0
//
// Scenes in OBJ, with materials in MTL.

#pragma once

#include "../../scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// As `importScene` says.
Scene importObj(const std::string& path, uint64_t mostTriangles);

} // namespace wellstrat::render
