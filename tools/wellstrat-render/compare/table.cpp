// SPDX-License-Identifier: Apache-2.0

#include "table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace wellstrat::cli {
namespace {

std::size_t widthOfNames(const Comparison& comparison) {
    std::size_t width = 9;
    for (const auto& generator : comparison.generators) {
        width = std::max(width, generator.name.size());
    }
    return width;
}

std::string headOf(const Comparison& comparison, std::size_t width) {
    std::string text =
        fmt::format("{}, reference: {}\n", comparison.scene, comparison.reference.origin);
    if (isMasked(comparison)) {
        text += fmt::format("errors of {:.1f} % of the pixels, {}\n",
                            percentOf(comparison.measure.mask), comparison.maskOrigin);
    }
    text += fmt::format("{:<{}} {:>8} {:>12} {:>12}", "generator", width, "samples", "RMSE",
                        "relative MSE");
    const auto addFiltered = [&](const char* sign) {
        for (const render::GaussianBlur& blur : comparison.measure.blurs) {
            text += fmt::format(" {:>12}", sign + ("at " + filterName(blur.sigma())));
        }
    };
    addFiltered("");
    text += fmt::format(" {:>9} {:>14}", "seconds", "as " + baselineOf(comparison).name);
    if (hasUncertainties(comparison)) {
        text += fmt::format(" {:>12}", "+- RMSE");
        addFiltered("+- ");
    }
    return text + '\n';
}

std::string lineOf(const ComparedImage& image, const ComparedGenerator& baseline) {
    std::string text = fmt::format(" {:>8} {:>12.4e} {:>12.4e}", image.samples, image.error.rmse,
                                   image.error.relativeMse);
    for (const double filtered : image.error.filtered) text += fmt::format(" {:>12.4e}", filtered);
    text += fmt::format(" {:>9.2f} {:>14.1f}", image.seconds,
                        equivalentSamples(baseline, image.error.rmse));
    if (image.uncertainty) {
        text += fmt::format(" {:>12.1e}", image.uncertainty->rmse);
        for (const double filtered : image.uncertainty->filtered) {
            text += fmt::format(" {:>12.1e}", filtered);
        }
    }
    return text + '\n';
}

std::string relativeTable(const Comparison& comparison, std::size_t width) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    std::string text = fmt::format("\nRMSE relative to {}, after filters, by samples\n{:<{}} {:>8}",
                                   baseline.name, "generator", width, "filter");
    for (const ComparedImage& image : baseline.images) text += fmt::format(" {:>8}", image.samples);
    text += '\n';
    for (const RelativeErrors& row : relativeErrors(comparison)) {
        text += fmt::format("{:<{}} {:>8}", row.generator, width, row.filter);
        for (const double ratio : row.ratios) text += fmt::format(" {:>8}", ratioText(ratio));
        text += '\n';
    }
    return text;
}

} // namespace

std::string compareTable(const Comparison& comparison) {
    const std::size_t width = widthOfNames(comparison);
    std::string text = headOf(comparison, width);
    for (const ComparedGenerator& generator : comparison.generators) {
        for (const ComparedImage& image : generator.images) {
            text += fmt::format("{:<{}}", generator.name, width) +
                    lineOf(image, baselineOf(comparison));
        }
    }
    if (comparison.generators.size() > 1) text += relativeTable(comparison, width);
    return text;
}

} // namespace wellstrat::cli
