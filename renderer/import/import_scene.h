// SPDX-License-Identifier: Apache-2.0
//
// Reads a scene file by Assimp, in this process.

#pragma once

#include "../scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// Bounds the memory of a scene: instances are copied.
constexpr uint64_t kMostTriangles = 100'000'000;

/// What Assimp finds in a file, in our terms: all that can be rendered, copied into world space as
/// often as nodes refer to it, and notes on the rest. Adds no light and no camera where there is
/// none. Throws std::runtime_error with one line that says why the file cannot be read, that it has
/// more than `mostTriangles`, all instances counted, or why it has none to render.
///
/// There are files that Assimp does not survive, nor does the process. `readScene` is the safe way.
Scene importScene(const std::string& path, uint64_t mostTriangles = kMostTriangles);

} // namespace wellstrat::render
