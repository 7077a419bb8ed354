// SPDX-License-Identifier: Apache-2.0
//
// Scenes and environment maps from files.

#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace wellstrat::render {

/// Reads a scene in any format that Assimp knows; glTF 2.0 and OBJ with MTL are those that say
/// most. The scene can be rendered as it is: one without light gets a soft constant environment,
/// one without camera gets one that shows all of it (`cameraIsAutomatic`). What was replaced or
/// left out stands in `notes`. import/ has the conventions.
///
/// Throws std::runtime_error with one line: the file is missing, cannot be read, or has no
/// triangles to render. So are files that Assimp does not survive, or not within ten minutes and
/// the memory that there is: it runs in a process of its own. Call this before starting threads.
Scene readScene(const std::string& path);

/// Reads a latitude-longitude map, a .hdr or .exr file, or any other that OpenImageIO reads.
/// Values that cannot be light are replaced as `readTexture` says; `notes`, unless null, gets a
/// sentence on that. Throws std::runtime_error with one line.
Environment readEnvironment(const std::string& path, std::vector<std::string>* notes = nullptr);

} // namespace wellstrat::render
