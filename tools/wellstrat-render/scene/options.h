// SPDX-License-Identifier: Apache-2.0
//
// The options that all commands which render share: the scene, its camera, and how it is sampled.

#pragma once

#include "wellstrat/vector.h"

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace wellstrat::cli {

struct ImageSize {
    unsigned width, height;
};

struct SceneOptions {
    std::string scene;
    std::optional<std::string> environment;
    std::optional<double> environmentRotation; ///< degrees
    std::optional<double> environmentStrength;
    std::string studio = "auto";           ///< or "on" or "off"
    std::optional<std::string> cameraName; ///< of a scene file
    std::optional<uint64_t> cameraNumber;  ///< from 1
    std::optional<Float3> position, lookAt, up;
    std::optional<double> fov; ///< degrees
    std::optional<double> lensRadius, focus;
    std::optional<ImageSize> size;

    uint64_t depth = 5, split = 1, seed = 0;
    bool distrib = false, transparent = false;
    std::optional<uint64_t> threads;
};

/// Returns the argument that names the scene. `options` must outlive `command`.
CLI::Option* addSceneOptions(CLI::App& command, SceneOptions& options);

/// The options as arguments of a command line for a shell, with all that has a default.
std::string sceneArguments(const SceneOptions& options, ImageSize size);

} // namespace wellstrat::cli
