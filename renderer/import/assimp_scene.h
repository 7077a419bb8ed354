// SPDX-License-Identifier: Apache-2.0
//
// Scenes by Assimp: all formats but glTF, OBJ and PLY.

#pragma once

#include "../scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// As `importScene` says.
Scene importByAssimp(const std::string& path, uint64_t mostTriangles);

} // namespace wellstrat::render
