// SPDX-License-Identifier: Apache-2.0

#include "result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wellstrat::cli {
namespace {

bool isExact(const ComparedImage& image) { return image.error.rmse == 0; }

/// The samples with which a power law through two points of a curve reaches `rmse`.
double powerLaw(const ComparedImage& a, double exponent, double rmse) {
    return a.samples * std::pow(rmse / a.error.rmse, 1 / exponent);
}

/// The RMSE after filter 1, 2, ..., or without for 0.
double rmseAfter(std::size_t filter, const render::FilmError& error) {
    return filter == 0 ? error.rmse : error.filtered[filter - 1];
}

} // namespace

const ComparedGenerator& baselineOf(const Comparison& comparison) {
    const auto& all = comparison.generators;
    const auto random = std::find_if(all.begin(), all.end(),
                                     [](const ComparedGenerator& g) { return g.name == "random"; });
    return random == all.end() ? all.back() : *random;
}

double equivalentSamples(const ComparedGenerator& baseline, double rmse) {
    const auto& images = baseline.images;
    if (rmse == 0) {
        const auto exact = std::find_if(images.begin(), images.end(), isExact);
        return exact == images.end() ? std::numeric_limits<double>::infinity() : exact->samples;
    }
    for (std::size_t i = 1; i < images.size(); ++i) {
        const ComparedImage &a = images[i - 1], &b = images[i];
        if (!(rmse <= a.error.rmse && rmse >= b.error.rmse && a.error.rmse > b.error.rmse)) {
            continue;
        }
        const double exponent =
            std::log(b.error.rmse / a.error.rmse) / std::log(double(b.samples) / double(a.samples));
        return powerLaw(a, exponent, rmse);
    }
    return powerLaw(rmse > images.front().error.rmse ? images.front() : images.back(), -0.5, rmse);
}

bool hasErrors(const Comparison& comparison) {
    return !std::all_of(comparison.generators.begin(), comparison.generators.end(),
                        [](const ComparedGenerator& generator) {
                            return std::all_of(generator.images.begin(), generator.images.end(),
                                               isExact);
                        });
}

bool hasUncertainties(const Comparison& comparison) {
    return comparison.generators.front().images.front().uncertainty.has_value();
}

bool isMasked(const Comparison& comparison) {
    return countOf(comparison.measure.mask) < comparison.measure.mask.counts.size();
}

double percentOf(const render::PixelMask& mask) {
    return 100 * static_cast<double>(countOf(mask)) / static_cast<double>(mask.counts.size());
}

std::string samplesText(uint32_t samples) {
    return fmt::format("{} {}", samples, samples == 1 ? "sample" : "samples");
}

std::string filterName(double sigma) { return fmt::format("{:g}px", sigma); }

std::vector<RelativeErrors> relativeErrors(const Comparison& comparison) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    const auto& blurs = comparison.measure.blurs;
    std::vector<RelativeErrors> rows;
    for (const ComparedGenerator& generator : comparison.generators) {
        if (&generator == &baseline) continue;
        for (std::size_t filter = 0; filter <= blurs.size(); ++filter) {
            rows.push_back(
                {generator.name, filter == 0 ? "none" : filterName(blurs[filter - 1].sigma()), {}});
            for (std::size_t i = 0; i < generator.images.size(); ++i) {
                rows.back().ratios.push_back(rmseAfter(filter, generator.images[i].error) /
                                             rmseAfter(filter, baseline.images[i].error));
            }
        }
    }
    return rows;
}

std::string ratioText(double ratio) {
    return std::isfinite(ratio) ? fmt::format("{:.3f}", ratio) : "-";
}

} // namespace wellstrat::cli
