// SPDX-License-Identifier: Apache-2.0

#include "verdict.h"

#include "common/output/readable_names.h"

#include <fmt/format.h>

#include <cmath>

namespace wellstrat::cli {
namespace {

double rmseOf(const ComparedGenerator& generator) { return generator.images.back().error.rmse; }

/// The one with the least error at the end, other than the baseline; null if there is none.
const ComparedGenerator* bestOthers(const Comparison& comparison) {
    const ComparedGenerator *const baseline = &baselineOf(comparison), *best = nullptr;
    for (const ComparedGenerator& generator : comparison.generators) {
        if (&generator == baseline) continue;
        if (!best || rmseOf(generator) < rmseOf(*best)) best = &generator;
    }
    return best;
}

/// Two standard errors of the logarithm of a quotient of both errors.
double uncertaintyOf(const ComparedImage& a, const ComparedImage& b) {
    if (!a.uncertainty || !b.uncertainty) return 0;
    return 2 * std::hypot(a.uncertainty->rmse / a.error.rmse, b.uncertainty->rmse / b.error.rmse);
}

} // namespace

std::string verdictOf(const Comparison& comparison) {
    if (!hasErrors(comparison)) return "No image differs from the reference.";
    const ComparedGenerator& baseline = baselineOf(comparison);
    const ComparedGenerator* const best = bestOthers(comparison);
    const ComparedImage& last = baseline.images.back();
    const std::string samples = "With " + samplesText(last.samples) + " of each pixel";
    const std::string baselineName = "\u201c" + generatorTitle(baseline.name) + "\u201d";
    if (!best) return fmt::format("{}, the RMSE is {:.2g}.", samples, rmseOf(baseline));
    const std::string name = "\u201c" + generatorTitle(best->name) + "\u201d";
    const double ratio = rmseOf(*best) / rmseOf(baseline);
    if (!(std::log(ratio) < -uncertaintyOf(best->images.back(), last))) {
        return fmt::format(
            "{}, none is clearly better than {}: the best of the others, {}, has {:.2f} of its "
            "error.",
            samples, baselineName, name, ratio);
    }
    return fmt::format(
        "{}, {} has {:.2f} of the error of {}, which needs about {:.0f} for the same.", samples,
        name, ratio, baselineName, equivalentSamples(baseline, rmseOf(*best)));
}

} // namespace wellstrat::cli
