// SPDX-License-Identifier: Apache-2.0
//
// Scenes in PLY.

#pragma once

#include "../../scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// As `importScene` says. Where the vertices have colors or a picture, the surface has them,
/// otherwise it is light gray; it is diffuse.
Scene importPly(const std::string& path, uint64_t mostTriangles);

} // namespace wellstrat::render
