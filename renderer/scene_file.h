// SPDX-License-Identifier: Apache-2.0
//
// Scenes and environment maps from files.

#pragma once

#include "scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::render {

/// Which camera of a scene file sees the picture; the first if neither is set.
struct CameraChoice {
    std::optional<std::string> name;
    std::optional<std::size_t> number; ///< from 1; counts of what the name leaves
};

/// Reads a scene in glTF 2.0, OBJ with MTL, PLY, or any other format that Assimp knows. The scene can be
/// rendered as it is: one without camera gets one that shows all of it (`cameraIsAutomatic`); one
/// without light is dark (studio.h). What was replaced or left out stands in `notes`.
/// import/ has the conventions.
///
/// Throws std::runtime_error with one line: the file is missing, cannot be read, has no triangles
/// to render, or not the camera that was chosen. So are files that the importer does not survive,
/// or not within ten minutes and the memory that there is: it runs in a process of its own. Call
/// this before starting threads.
Scene readScene(const std::string& path, const CameraChoice& camera = {});

/// Reads a latitude-longitude map, a .hdr or .exr file, or any other that OpenImageIO reads.
/// Values that cannot be light are replaced as `readTexture` says; `notes`, unless null, gets
/// sentences on that. Throws std::runtime_error with one line.
Environment readEnvironment(const std::string& path, std::vector<std::string>* notes = nullptr);

} // namespace wellstrat::render
