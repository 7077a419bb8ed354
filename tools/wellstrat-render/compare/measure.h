// SPDX-License-Identifier: Apache-2.0
//
// Measures the errors of images.

#pragma once

#include "result.h"

#include "renderer/film.h"
#include "renderer/film_error.h"

#include <optional>
#include <vector>

namespace wellstrat::cli {

/// The images of one generator with the same samples, by seed.
using FilmsBySeed = std::vector<render::Film>;

render::Film meanOf(const FilmsBySeed& films);

/// What is measured of images.
struct MeasuredErrors {
    render::FilmError error;
    std::optional<Uncertainty> uncertainty; ///< where it is known
    std::vector<RingPower> spectrum;
};

/// Measures how far an image is from `reference`. Of several the latter must be the mean: then it
/// is the error of one image that is measured, by how far they are from each other, and with its
/// uncertainty.
MeasuredErrors measureErrors(const FilmsBySeed& films, const render::Film& reference,
                             const render::ErrorMeasure& measure);

} // namespace wellstrat::cli
