// SPDX-License-Identifier: Apache-2.0
//
// What wellstrat compare finds out.

#pragma once

#include "crops.h"

#include "renderer/film.h"
#include "renderer/film_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {

/// The standard errors of two numbers of a FilmError.
struct Uncertainty {
    double rmse;
    std::vector<double> filtered;
};

/// An image of one generator after some samples.
struct ComparedImage {
    uint32_t samples;
    render::FilmError error;
    std::optional<Uncertainty> uncertainty; ///< where it is known
    double seconds;                         ///< that all its samples took
    std::vector<RingPower> spectrum;        ///< of the errors that count
    render::Film crop;                      ///< enlarged
    std::vector<render::Film> blurredCrops; ///< of the whole image after each blur, enlarged
};

/// A generator with an image for each number of samples.
struct ComparedGenerator {
    std::string name;
    std::vector<ComparedImage> images;
};

/// What images are compared with.
struct Reference {
    render::Film film;
    std::string origin;          ///< where it comes from, a clause
    std::optional<double> error; ///< its own RMSE, where that is known
};

struct Comparison {
    /// Nothing is compared yet, and the reference is black.
    Comparison(std::string name, unsigned width, unsigned height)
        : scene(std::move(name)), reference{render::Film(width, height), "", {}} {}

    std::string scene;
    Reference reference;
    render::ErrorMeasure measure{};
    std::string maskOrigin; ///< which pixels count, if not all: a noun phrase
    Crop crop{};
    std::vector<render::Film> blurredReference; ///< the crop after each blur, enlarged
    std::vector<ComparedGenerator> generators;
};

/// The generator whose samples others are converted to: "random", else the last one.
const ComparedGenerator& baselineOf(const Comparison& comparison);

/// How many samples the baseline needs for this RMSE: on the line through its points in a plot with
/// logarithmic axes, beyond them by the law of independent samples, RMSE ~ samples^(-1/2). For an
/// RMSE of 0 its first image without error, or infinity.
double equivalentSamples(const ComparedGenerator& baseline, double rmse);

/// Whether the uncertainties of the errors are known: of all images or of none.
bool hasUncertainties(const Comparison& comparison);

/// Whether any image differs from the reference.
bool hasErrors(const Comparison& comparison);

/// Whether some pixels do not count.
bool isMasked(const Comparison& comparison);

/// Which part of the pixels counts, in percent.
double percentOf(const render::PixelMask& mask);

/// "1 sample", "4 samples".
std::string samplesText(uint32_t samples);

/// How tables call a blur, such as "2px".
std::string filterName(double sigma);

/// The RMSE of a generator's images over that of the baseline's with as many samples.
struct RelativeErrors {
    std::string generator;
    std::string filter;         ///< after which blur, or "none"
    std::vector<double> ratios; ///< for each number of samples; not finite where they mean nothing
};

/// Of all generators but the baseline.
std::vector<RelativeErrors> relativeErrors(const Comparison& comparison);

/// A ratio, or a dash if it means nothing.
std::string ratioText(double ratio);

} // namespace wellstrat::cli
