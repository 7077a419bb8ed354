// SPDX-License-Identifier: Apache-2.0

#include "run.h"

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/output/readable_names.h"
#include "image/run.h"
#include "measure.h"

#include "renderer/film_error.h"
#include "renderer/pixel_mask.h"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr uint64_t kReferenceFactor = 8;

ImageRun imageOf(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                 const std::string& name, uint64_t seed) {
    return ImageRun(options.scene, seed, *job.scene, job.size, renderGenerator(name), ranks, name);
}

/// Where the errors that --seeds measures are from.
std::string originOfMeans(const CompareOptions& options, const std::string& name,
                          uint32_t samples) {
    return fmt::format(
        "the mean of each image over its {} seeds; shown is that of \u201c{}\u201d with {} "
        "samples of each pixel",
        *options.seeds, generatorTitle(name), samples);
}

/// Fills in what the options ask to measure, smooth areas as they are in the reference.
void chooseMeasure(const CompareOptions& options, const CompareJob& job, Comparison& comparison) {
    render::PixelMask mask = render::allPixels(job.size.width, job.size.height);
    if (job.mask) {
        mask = *job.mask;
        comparison.maskOrigin = "those that are not black in " + oneLine(*options.mask);
    } else if (options.mask) {
        mask = render::smoothAreas(comparison.reference.film);
        comparison.maskOrigin = "the smooth areas of " + comparison.reference.origin;
    }
    if (countOf(mask) == 0) {
        throw CliError(
            fmt::format("--mask smooth: no pixel of the reference is in a smooth area, "
                        "where the contrast of {0}x{0} pixels is at most {1}; less noise "
                        "in the reference or a larger --size may help",
                        2 * render::kSmoothReach + 1, render::kSmoothContrast));
    }
    comparison.measure = render::errorMeasure(std::move(mask), options.filters);
}

/// Renders a reference as two halves of other seeds, whose difference tells its error: halves A and
/// B are independent and equally wrong, so the RMSE of (A + B) / 2 is half that between A and B.
/// False if it was interrupted.
bool renderReference(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                     Comparison& comparison) {
    const auto samples = static_cast<uint32_t>((referenceSamples(options) + 1) / 2);
    const uint64_t seeds[2]{options.scene.seed ^ kMaxWord, options.scene.seed ^ (kMaxWord - 1)};
    std::vector<render::Film> halves;
    for (const uint64_t seed : seeds) {
        ImageRun run = imageOf(options, job, ranks, "pmj", seed);
        if (!run.render(samples)) return false;
        halves.push_back(run.film());
    }
    if (!ranks.isRoot()) return true;
    Reference& reference = comparison.reference;
    reference.film = meanOf(halves);
    reference.origin =
        fmt::format("twice {} samples of each pixel, seeds {} and {}", samples, seeds[0], seeds[1]);
    chooseMeasure(options, job, comparison);
    reference.error = render::filmError(halves[0], halves[1], comparison.measure).rmse / 2;
    return true;
}

/// Fills in the reference that the options ask for, and what is measured. False if it was
/// interrupted.
bool findReference(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                   Comparison& comparison) {
    const bool isNeeded = !options.seeds || options.mask == kSmoothMask;
    if (isNeeded && !job.reference) return renderReference(options, job, ranks, comparison);
    if (!ranks.isRoot()) return true;
    if (isNeeded) {
        comparison.reference = {job.reference->film,
                                fmt::format("{}, by {}", oneLine(*options.reference),
                                            job.reference->settings.at("generator")),
                                {}};
    }
    chooseMeasure(options, job, comparison);
    return true;
}

/// Renders the images of a generator, films[i][k] with options.spp[i] samples and seed k, and says
/// how many seconds options.spp[i] samples took. False if it was interrupted.
bool renderImages(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                  const std::string& name, std::vector<FilmsBySeed>& films,
                  std::vector<double>& seconds) {
    films.resize(options.spp.size());
    seconds.resize(options.spp.size());
    const uint64_t seeds = options.seeds.value_or(1);
    for (uint64_t k = 0; k < seeds; ++k) {
        ImageRun run = imageOf(options, job, ranks, name, options.scene.seed + k);
        for (std::size_t i = 0; i < films.size(); ++i) {
            if (!run.render(options.spp[i])) return false;
            films[i].push_back(run.film());
            seconds[i] += run.seconds() / static_cast<double>(seeds);
        }
    }
    return true;
}

/// Measures the images of one more generator, films[i][k] as of renderImages.
void addGenerator(const CompareOptions& options, const CompareJob& job, const std::string& name,
                  const std::vector<FilmsBySeed>& films, const std::vector<double>& seconds,
                  Comparison& comparison) {
    const bool isFirst = comparison.generators.empty();
    comparison.generators.push_back({name, {}});
    Reference& reference = comparison.reference;
    const auto blurs =
        render::errorMeasure(render::allPixels(job.size.width, job.size.height), options.filters)
            .blurs;
    for (std::size_t i = 0; i < films.size(); ++i) {
        const render::Film& first = films[i].front();
        if (options.seeds) {
            reference = {meanOf(films[i]), originOfMeans(options, name, options.spp[i]), {}};
        }
        if (isFirst && i == 0) comparison.crop = worstCrop(first, reference.film);
        MeasuredErrors errors = measureErrors(films[i], reference.film, comparison.measure);
        comparison.generators.back().images.push_back(
            {options.spp[i], std::move(errors.error), std::move(errors.uncertainty), seconds[i],
             std::move(errors.spectrum), enlarged(first, comparison.crop),
             blurredCrops(first, blurs, comparison.crop)});
    }
    comparison.blurredReference = blurredCrops(reference.film, blurs, comparison.crop);
}

} // namespace

bool renderComparison(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                      Comparison& comparison) {
    if (!findReference(options, job, ranks, comparison)) return false;
    for (const std::string& name : options.generators) {
        std::vector<FilmsBySeed> films;
        std::vector<double> seconds;
        if (!renderImages(options, job, ranks, name, films, seconds)) return false;
        if (ranks.isRoot()) addGenerator(options, job, name, films, seconds, comparison);
    }
    return true;
}

uint64_t referenceSamples(const CompareOptions& options) {
    return options.referenceSpp.value_or(kReferenceFactor * options.spp.back());
}

} // namespace wellstrat::cli
