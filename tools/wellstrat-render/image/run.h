// SPDX-License-Identifier: Apache-2.0
//
// One image of a scene, as the commands that measure images render it.

#pragma once

#include "common/ranks/ranks.h"
#include "scene/options.h"

#include "renderer/film.h"
#include "renderer/render.h"

#include <cstdint>
#include <memory>
#include <string>

namespace wellstrat::cli {

constexpr uint64_t kMostMeasuredSamples = 1 << 24; ///< of a pixel

/// Renders an image, with more and more samples.
class ImageRun {
public:
    /// `generator` is null for the tables. `label` says in the progress bar what is rendered. The
    /// scene and the ranks must outlive this.
    ImageRun(SceneOptions options, uint64_t seed, const render::Scene& scene, ImageSize size,
             const Generator* generator, const Ranks& ranks, std::string label);

    /// Goes on to `samples` of each pixel. False if it was interrupted.
    bool render(uint32_t samples);

    const render::Film& film() const { return film_; } ///< complete on rank 0
    double seconds() const { return seconds_; }

private:
    const Ranks& ranks_;
    std::string label_;
    render::Film film_;
    std::unique_ptr<render::Renderer> renderer_;
    double seconds_ = 0;
};

} // namespace wellstrat::cli
