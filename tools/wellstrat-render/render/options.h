// SPDX-License-Identifier: Apache-2.0
//
// The options of wellstrat render.

#pragma once

#include "image/display.h"
#include "scene/options.h"

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// Samples begin to end - 1 of each pixel of a picture.
struct SampleSpan {
    uint32_t begin, end;
};

/// In one command.
constexpr uint64_t kMostFrames = 100000;

struct RenderOptions {
    SceneOptions scene;
    std::string generator = "pmj";
    std::vector<std::string> outputs;
    DisplayOptions display;
    std::optional<uint64_t> spp;
    std::optional<SampleSpan> samples;
    std::optional<uint64_t> frame, frames; ///< the first one, and how many
    std::optional<double> orbit;           ///< degrees of the camera's way from frame to frame
    std::optional<double> timeLimit, noise;
    std::optional<std::string> checkpoint, resume;
    uint64_t saveEvery = 30;
    bool list = false;
};

/// `options` must outlive `command`.
void addRenderOptions(CLI::App& command, RenderOptions& options);

} // namespace wellstrat::cli
