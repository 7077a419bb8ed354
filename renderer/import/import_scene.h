// SPDX-License-Identifier: Apache-2.0
//
// Reads a scene file by Assimp, in this process.

#pragma once

#include "../scene.h"

#include <string>

namespace wellstrat::render {

/// What Assimp finds in a file, in our terms: all that can be rendered, copied into world space as
/// often as nodes refer to it, and notes on the rest. Adds no light and no camera where there is
/// none. Throws std::runtime_error with one line that says why the file cannot be read, or why it
/// has no triangles to render.
///
/// A file made to harm can crash Assimp, and with it the process. `readScene` is the safe way.
Scene importScene(const std::string& path);

} // namespace wellstrat::render
