// SPDX-License-Identifier: Apache-2.0
//
// Reads a scene file in this process.

#pragma once

#include "../scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

/// Bounds the memory of a scene: instances are copied.
constexpr uint64_t kMostTriangles = 100'000'000;

/// What a file holds, in our terms: all that can be rendered, copied into world space as often as
/// nodes refer to it, all cameras, and notes on the rest. Files that end with .gltf, .glb, .ply
/// or .obj, and those that begin as .glb and .ply files do, are read by gltf/, ply/ and obj/, all
/// others by Assimp. Adds no light and
/// chooses no camera. Throws std::runtime_error with one line that says why the file cannot be
/// read, that it has more than `mostTriangles`, all instances counted, or why it has none to
/// render.
///
/// There are files that the libraries do not survive, nor does the process. `readScene` is the safe
/// way.
Scene importScene(const std::string& path, uint64_t mostTriangles = kMostTriangles);

} // namespace wellstrat::render
