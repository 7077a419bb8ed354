// SPDX-License-Identifier: Apache-2.0

#include "result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace wellstrat::cli {
namespace {

constexpr unsigned kCropSize = 96;
constexpr unsigned kEnlargement = 4;
constexpr double kDark = 0.01; ///< as in the relative MSE

double clampedDifference(const render::Film& film, const render::Film& reference, unsigned x,
                         unsigned y) {
    const Float3 a = film.mean(x, y), b = reference.mean(x, y);
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
        const double right{b[c]}, d = double{a[c]} - right;
        sum += std::min(d * d / (right * right + kDark), 1.0);
    }
    return sum;
}

bool isExact(const ComparedImage& image) { return image.error.rmse == 0; }

/// The samples with which a power law through two points of a curve reaches `rmse`.
double powerLaw(const ComparedImage& a, double exponent, double rmse) {
    return a.samples * std::pow(rmse / a.error.rmse, 1 / exponent);
}

} // namespace

Crop worstCrop(const render::Film& film, const render::Film& reference) {
    const unsigned width = std::min(kCropSize, film.width());
    const unsigned height = std::min(kCropSize, film.height());
    Crop worst{0, 0, width, height};
    double most = -1;
    for (unsigned y = 0; y + height <= film.height(); y += kCropSize / 4) {
        for (unsigned x = 0; x + width <= film.width(); x += kCropSize / 4) {
            double sum = 0;
            for (unsigned j = 0; j < height; ++j) {
                for (unsigned i = 0; i < width; ++i) {
                    sum += clampedDifference(film, reference, x + i, y + j);
                }
            }
            if (sum <= most) continue;
            most = sum;
            worst = {x, y, width, height};
        }
    }
    return worst;
}

render::Film enlarged(const render::Film& film, const Crop& crop) {
    render::Film large(crop.width * kEnlargement, crop.height * kEnlargement);
    for (unsigned y = 0; y < large.height(); ++y) {
        for (unsigned x = 0; x < large.width(); ++x) {
            large.pixel(x, y) = film.pixel(crop.x + x / kEnlargement, crop.y + y / kEnlargement);
        }
    }
    return large;
}

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

std::string compareTable(const Comparison& comparison) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    std::size_t width = 9;
    for (const auto& generator : comparison.generators) {
        width = std::max(width, generator.name.size());
    }
    std::string text =
        fmt::format("{}, reference: {}\n{:<{}} {:>8} {:>12} {:>12} {:>12} {:>9} {:>14}",
                    comparison.scene, comparison.reference.origin, "generator", width, "samples",
                    "RMSE", "relative MSE", "filtered", "seconds", "as " + baseline.name);
    if (hasUncertainties(comparison))
        text += fmt::format(" {:>12} {:>12}", "+- RMSE", "+- filtered");
    text += '\n';
    for (const ComparedGenerator& generator : comparison.generators) {
        for (const ComparedImage& image : generator.images) {
            fmt::format_to(std::back_inserter(text),
                           "{:<{}} {:>8} {:>12.4e} {:>12.4e} {:>12.4e} {:>9.2f} {:>14.1f}",
                           generator.name, width, image.samples, image.error.rmse,
                           image.error.relativeMse, image.error.filtered, image.seconds,
                           equivalentSamples(baseline, image.error.rmse));
            if (image.uncertainty) {
                fmt::format_to(std::back_inserter(text), " {:>12.1e} {:>12.1e}",
                               image.uncertainty->rmse, image.uncertainty->filtered);
            }
            text += '\n';
        }
    }
    return text;
}

} // namespace wellstrat::cli
