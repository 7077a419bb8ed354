// SPDX-License-Identifier: Apache-2.0

#include "run.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "image/run.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr uint64_t kReferenceFactor = 8;

ImageRun imageOf(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                 const std::string& name, uint64_t seed) {
    return ImageRun(options.scene, seed, *job.scene, job.size, renderGenerator(name), ranks, name);
}

/// Renders a reference as two halves of other seeds, whose difference tells its error: halves A and
/// B are independent and equally wrong, so the RMSE of (A + B) / 2 is half that between A and B.
/// False if it was interrupted.
bool renderReference(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                     Reference& reference) {
    const auto samples = static_cast<uint32_t>((referenceSamples(options) + 1) / 2);
    const uint64_t seeds[2]{options.scene.seed ^ kMaxWord, options.scene.seed ^ (kMaxWord - 1)};
    std::optional<render::Film> first;
    for (const uint64_t seed : seeds) {
        ImageRun run = imageOf(options, job, ranks, "pmj", seed);
        if (!run.render(samples)) return false;
        if (!first) {
            first = run.film();
            continue;
        }
        reference.error = render::filmError(*first, run.film()).rmse / 2;
        reference.film = std::move(*first);
        reference.film.add(run.film());
    }
    reference.origin = fmt::format("pmj, twice {} samples of each pixel, seeds {} and {}", samples,
                                   seeds[0], seeds[1]);
    return true;
}

/// Fills in the reference that the options ask for. False if it was interrupted.
bool findReference(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                   Reference& reference) {
    if (options.seeds) return true; // each image has its own
    if (!job.reference) return renderReference(options, job, ranks, reference);
    reference.film = job.reference->film;
    reference.origin = fmt::format("{}, by {}", oneLine(*options.reference),
                                   job.reference->settings.at("generator"));
    return true;
}

/// The images of one generator with the same samples, by seed.
using FilmsBySeed = std::vector<render::Film>;

/// Their mean.
Reference meanOf(const FilmsBySeed& films, const std::string& name, uint32_t samples) {
    render::Film sum = films.front();
    for (std::size_t k = 1; k < films.size(); ++k) sum.add(films[k]);
    return {std::move(sum),
            fmt::format("the mean of each image over its {} seeds; shown is that of {} with {} "
                        "samples of each pixel",
                        films.size(), name, samples),
            {}};
}

double square(double x) { return x * x; }

struct RootMeanSquare {
    double value, standardError;
};

/// From the mean squares of the differences of K images from their mean: those of the expectation
/// are larger by K / (K - 1).
RootMeanSquare errorOfOne(const std::vector<double>& squares) {
    const auto count = static_cast<double>(squares.size());
    double sum = 0, deviations = 0;
    for (const double x : squares) sum += x;
    for (const double x : squares) deviations += square(x - sum / count);
    if (sum == 0) return {0, 0};
    const double value = std::sqrt(sum / (count - 1));
    const double relative = std::sqrt(deviations / (count - 1) / count) / (sum / count);
    return {value, value * relative / 2}; // the root has half the relative error
}

/// Measures the error of one image by how `films` differ from their mean.
void measureSpread(const FilmsBySeed& films, const render::Film& mean, ComparedImage& image) {
    std::vector<double> squares, relative, filtered;
    for (const render::Film& film : films) {
        const render::FilmError error = render::filmError(film, mean);
        squares.push_back(square(error.rmse));
        relative.push_back(error.relativeMse);
        filtered.push_back(square(error.filtered));
    }
    const RootMeanSquare plain = errorOfOne(squares), blurred = errorOfOne(filtered);
    image.error = {plain.value, square(errorOfOne(relative).value), blurred.value};
    image.uncertainty = {plain.standardError, blurred.standardError};
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

} // namespace

bool renderComparison(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                      Comparison& comparison) {
    if (!findReference(options, job, ranks, comparison.reference)) return false;
    for (const std::string& name : options.generators) {
        std::vector<FilmsBySeed> films;
        std::vector<double> seconds;
        if (!renderImages(options, job, ranks, name, films, seconds)) return false;
        if (!ranks.isRoot()) continue;
        comparison.generators.push_back({name, {}});
        for (std::size_t i = 0; i < films.size(); ++i) {
            const render::Film& first = films[i].front();
            ComparedImage image{options.spp[i], {}, {}, seconds[i], first};
            if (options.seeds) {
                comparison.reference = meanOf(films[i], name, options.spp[i]);
                measureSpread(films[i], comparison.reference.film, image);
            } else {
                image.error = render::filmError(first, comparison.reference.film);
            }
            if (comparison.crop.width == 0) {
                comparison.crop = worstCrop(first, comparison.reference.film);
            }
            image.crop = enlarged(first, comparison.crop);
            comparison.generators.back().images.push_back(std::move(image));
        }
    }
    return true;
}

uint64_t referenceSamples(const CompareOptions& options) {
    return options.referenceSpp.value_or(kReferenceFactor * options.spp.back());
}

} // namespace wellstrat::cli
