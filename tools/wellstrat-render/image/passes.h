// SPDX-License-Identifier: Apache-2.0
//
// Renders an image in passes, on all cores of all processes, until it is done or told to stop.

#pragma once

#include "common/ranks/ranks.h"

#include "renderer/film.h"
#include "renderer/render.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace wellstrat::cli {

struct RenderPlan {
    uint32_t firstSample, endSample; ///< of each pixel
    std::optional<double> noise;     ///< error target, see film_noise.h
    std::optional<double> timeLimit; ///< seconds
    std::string label;               ///< of the progress bar
};

enum class RenderEnd { finished, interrupted, timeIsUp };

/// Adds the samples of `plan` that `film` lacks; each pixel of `film` has its first ones. Passes
/// double the number of samples, so that all of the image is there early, but last a second or two
/// at most. Tiles are dealt out to the ranks; their bits depend on none of this. Calls `save` with
/// all of the film on rank 0 every `savePeriod` seconds, if there is one. At the end, `film` is
/// complete on rank 0. SIGINT and SIGTERM end it after the tiles in work.
RenderEnd runRender(const render::Renderer& renderer, const RenderPlan& plan, const Ranks& ranks,
                    render::Film& film, std::optional<double> savePeriod,
                    const std::function<void(const render::Film&)>& save);

} // namespace wellstrat::cli
