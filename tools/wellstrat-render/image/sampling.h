// SPDX-License-Identifier: Apache-2.0
//
// How the options have an image sampled.

#pragma once

#include "common/command_line/generators.h"
#include "scene/options.h"

#include "renderer/render.h"
#include "renderer/scene.h"

#include <CLI/App.hpp>
#include <tbb/global_control.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace wellstrat::cli {

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

/// Names and values of all that decides the samples of an image.
std::map<std::string, std::string> imageSettings(const SceneOptions& options,
                                                 const std::string& fingerprint,
                                                 const std::string& generator);

/// How many samples a pixel has: 2^32 - 1, shared by those that --split makes of each.
uint64_t mostSamples(const SceneOptions& options);

/// Throws CliError, which names `option`, if samples 0 to `samples` - 1 of a pixel are more than
/// mostSamples.
void checkSamples(const SceneOptions& options, const std::string& option, uint64_t samples);

} // namespace wellstrat::cli
