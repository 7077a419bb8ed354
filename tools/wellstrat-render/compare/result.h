// SPDX-License-Identifier: Apache-2.0
//
// What wellstrat compare finds out, and shows.

#pragma once

#include "common/output/html_page.h"
#include "common/output/picture.h"

#include "renderer/film.h"
#include "renderer/film_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// A part of an image, in pixels.
struct Crop {
    unsigned x, y, width, height;
};

/// The standard errors of two numbers of a FilmError.
struct Uncertainty {
    double rmse, filtered;
};

/// An image of one generator after some samples.
struct ComparedImage {
    uint32_t samples;
    render::FilmError error;
    std::optional<Uncertainty> uncertainty; ///< where it is known
    double seconds;                         ///< that all its samples took
    render::Film crop;                      ///< enlarged
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
    std::string scene;
    Reference reference;
    Crop crop;
    std::vector<ComparedGenerator> generators;
};

/// The part of an image, at most 96 pixels squared, where `film` differs most from `reference`,
/// relative to its brightness. Differences count up to a limit, so that one bright pixel does not
/// decide.
Crop worstCrop(const render::Film& film, const render::Film& reference);

/// That part, its pixels enlarged to squares.
render::Film enlarged(const render::Film& film, const Crop& crop);

/// The generator whose samples others are converted to: "random", else the last one.
const ComparedGenerator& baselineOf(const Comparison& comparison);

/// How many samples the baseline needs for this RMSE: on the line through its points in a plot with
/// logarithmic axes, beyond them by the law of independent samples, RMSE ~ samples^(-1/2). For an
/// RMSE of 0 its first image without error, or infinity.
double equivalentSamples(const ComparedGenerator& baseline, double rmse);

/// Whether the uncertainties of the errors are known: of all images or of none.
bool hasUncertainties(const Comparison& comparison);

/// One line for each image.
std::string compareTable(const Comparison& comparison);

/// Whether any image differs from the reference.
bool hasErrors(const Comparison& comparison);

/// Error curves. Logarithmic axes need some error: see `hasErrors`.
Plot compareFigure(const Comparison& comparison);

/// The page, with `figure` the bytes of its error curves, empty if there are no errors. `command`
/// is what makes it again.
std::string comparePage(const Comparison& comparison, const std::string& figure,
                        const std::string& command);

} // namespace wellstrat::cli
