// SPDX-License-Identifier: Apache-2.0
//
// Renders what wellstrat compare compares, and measures the errors.

#pragma once

#include "common/output/output_file.h"
#include "common/output/picture.h"
#include "common/ranks/ranks.h"
#include "image/sampling.h"
#include "result.h"

#include "renderer/film_part.h"
#include "renderer/pixel_mask.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// The value of --mask for what is smooth in the reference.
constexpr auto kSmoothMask = "smooth";

struct CompareOptions {
    SceneOptions scene;
    std::vector<std::string> generators{"pmj", "random"};
    std::vector<uint32_t> spp{1, 4, 16, 64, 256, 1024};
    std::optional<std::string> reference;
    std::optional<uint64_t> referenceSpp;
    std::optional<uint64_t> seeds;
    std::vector<double> filters{2};  ///< standard deviations in pixels
    std::optional<std::string> mask; ///< kSmoothMask or a file
    std::string output;
    bool keepPlotFiles = false;
};

/// All that is made before anything is rendered.
struct CompareJob {
    std::unique_ptr<tbb::global_control> threads;
    std::unique_ptr<render::Scene> scene;
    ImageSize size{};
    std::optional<render::FilmPart> reference; ///< of --reference
    std::optional<render::PixelMask> mask;     ///< of a file
    std::unique_ptr<OutputFile> file;          ///< of rank 0
};

/// The samples of the reference, if one is rendered.
uint64_t referenceSamples(const CompareOptions& options);

/// Renders all images and measures their errors: against a reference or, with --seeds, by how much
/// images of other seeds differ. False if it was interrupted. Only rank 0 has images.
bool renderComparison(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                      Comparison& comparison);

} // namespace wellstrat::cli
