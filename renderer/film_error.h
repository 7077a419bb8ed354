// SPDX-License-Identifier: Apache-2.0
//
// How far an image is from a reference.

#pragma once

#include "film.h"

namespace wellstrat::render {

/// Means over all pixels and their three colors, of the difference d of the means of the samples.
struct FilmError {
    double rmse;        ///< sqrt(mean(d^2))
    double relativeMse; ///< mean(d^2 / (reference^2 + 0.01))
    double filtered;    ///< the RMSE after a blur of d: noise of high frequency, which the eye and
                        ///< denoisers forgive, counts less
};

/// The standard deviation, in pixels, of the Gaussian that blurs; it ends after three of them, and
/// at the edges of the image its weights are scaled to sum 1.
constexpr double kErrorBlur = 2;

/// Throws std::invalid_argument for films of different sizes.
FilmError filmError(const Film& film, const Film& reference);

} // namespace wellstrat::render
