// SPDX-License-Identifier: Apache-2.0
//
// How far an image is from a reference.

#pragma once

#include "film.h"
#include "gaussian_blur.h"
#include "pixel_mask.h"

#include "wellstrat/analysis/image_spectrum.h"

#include <vector>

namespace wellstrat::render {

/// Means over all pixels that count and their three colors, of the difference d of the means of the
/// samples.
struct FilmError {
    double rmse;                  ///< sqrt(mean(d^2))
    double relativeMse;           ///< mean(d^2 / (reference^2 + 0.01))
    std::vector<double> filtered; ///< for each blur, the RMSE of the blurred d: noise of high
                                  ///< frequency, which the eye and denoisers forgive, counts less
};

/// Which differences count, and the blurs after which they are measured too.
struct ErrorMeasure {
    PixelMask mask;
    std::vector<GaussianBlur> blurs;
};

/// Blurs among the pixels of the mask, with standard deviations in pixels.
ErrorMeasure errorMeasure(PixelMask mask, const std::vector<double>& sigmas);

/// Throws std::invalid_argument for films or a mask of different sizes, or if no pixel counts.
FilmError filmError(const Film& film, const Film& reference, const ErrorMeasure& measure);

/// Of all pixels, without blurs.
FilmError filmError(const Film& film, const Film& reference);

/// Adds the differences of each color, 0 for pixels that do not count. Throws as filmError does,
/// and for a spectrum of another size.
void addErrors(const Film& film, const Film& reference, const PixelMask& mask,
               ImagePeriodogram& spectrum);

} // namespace wellstrat::render
