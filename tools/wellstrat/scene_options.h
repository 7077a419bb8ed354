// SPDX-License-Identifier: Apache-2.0
//
// What the commands that render share: the scene, its camera, and how it is sampled.

#pragma once

#include "sampling.h"

#include "renderer/render.h"
#include "renderer/scene.h"

#include <CLI/App.hpp>
#include <tbb/global_control.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

struct ImageSize {
    unsigned width, height;
};

struct SceneOptions {
    std::string scene;
    std::optional<std::string> environment;
    std::optional<Float3> position, lookAt, up;
    std::optional<double> fov; ///< degrees
    std::optional<double> lensRadius, focus;
    std::optional<ImageSize> size;

    uint64_t depth = 5, split = 1, seed = 0;
    bool distrib = false;
    std::optional<uint64_t> threads;
};

/// Returns the argument that names the scene. `options` must outlive `command`.
CLI::Option* addSceneOptions(CLI::App& command, SceneOptions& options);

/// "name: description" of the built-in scenes, one a line.
std::string sceneList();

/// The scene with the camera and the environment that the options ask for. Its notes are not yet
/// said. Throws std::runtime_error with one line.
render::Scene loadScene(const SceneOptions& options);

/// The size asked for, or 256 rows in the shape of the scene. Throws CliError if its film does not
/// fit into memory.
ImageSize imageSize(const SceneOptions& options, const render::Scene& scene);

/// Throws CliError, which names `option`, if the machine has not so many bytes for `what`.
void requireMemory(const std::string& option, uint64_t bytes, const std::string& what);

/// What samples of the renderer's domains may come from: the generators of other commands, and
/// those that need marked domains.
const std::vector<NamedGenerator>& renderGenerators();

/// Adds --generators, a list of their names. `names` must outlive `command`.
CLI::Option* addRenderGenerators(CLI::App& command, std::vector<std::string>& names,
                                 const std::string& description);

/// The one of --generators that is called `name`, as makeRenderer takes it. Throws CliError.
const Generator* renderGenerator(const std::string& name);

/// What renders the scene; `generator` is null for the tables. Throws CliError.
std::unique_ptr<render::Renderer> makeRenderer(const SceneOptions& options,
                                               const render::Scene& scene, ImageSize size,
                                               const Generator* generator);

/// While what it returns exists, no more threads work than --threads says.
std::unique_ptr<tbb::global_control> limitThreads(const SceneOptions& options);

/// The options as arguments of a command line for a shell, with all that has a default.
std::string sceneArguments(const SceneOptions& options, ImageSize size);

/// A word of a command line as shells read it.
std::string shellWord(const std::string& text);

/// Names and values of all that decides the samples of an image.
std::map<std::string, std::string> imageSettings(const SceneOptions& options,
                                                 const std::string& fingerprint,
                                                 const std::string& generator);

/// Throws CliError, which names `option`, if samples 0 to `samples` - 1 of a pixel would be more
/// than there are: 2^32, shared by those that --split makes of each.
void checkSamples(const SceneOptions& options, const std::string& option, uint64_t samples);

/// Says the notes of a scene on the standard error, one a line.
void sayNotes(const render::Scene& scene);

} // namespace wellstrat::cli
