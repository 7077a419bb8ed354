// SPDX-License-Identifier: Apache-2.0
//
// The scene that the options ask for.

#pragma once

#include "options.h"

#include "renderer/scene.h"

#include <cstdint>
#include <string>

namespace wellstrat::cli {

/// "name: description" of the built-in scenes, one a line.
std::string sceneList();

/// The scene with the camera and the environment that the options ask for. Its notes are not yet
/// said. Throws std::runtime_error with one line.
render::Scene loadScene(const SceneOptions& options);

/// `camera` turned by `degrees` around --look-at, without it around the middle of the scene, about
/// --up. Throws CliError.
render::Camera orbitedCamera(const SceneOptions& options, const render::Scene& scene,
                             const render::Camera& camera, double degrees);

/// The size asked for, or 256 rows in the shape of the scene. Throws CliError if its film does not
/// fit into memory.
ImageSize imageSize(const SceneOptions& options, const render::Scene& scene);

/// Throws CliError, which names `option`, if the machine has not so many bytes for `what`.
void requireMemory(const std::string& option, uint64_t bytes, const std::string& what);

/// Says the notes of a scene on the standard error, one a line.
void sayNotes(const render::Scene& scene);

} // namespace wellstrat::cli
