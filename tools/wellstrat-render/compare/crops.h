// SPDX-License-Identifier: Apache-2.0
//
// Parts of images, enlarged so that pixels can be seen.

#pragma once

#include "renderer/film.h"
#include "renderer/gaussian_blur.h"

#include <vector>

namespace wellstrat::cli {

/// A part of an image, in pixels.
struct Crop {
    unsigned x, y, width, height;
};

/// The part of an image, at most 96 pixels squared, where `film` differs most from `reference`,
/// relative to its brightness. Differences count up to a limit, so that one bright pixel does not
/// decide.
Crop worstCrop(const render::Film& film, const render::Film& reference);

/// That part, its pixels enlarged to squares.
render::Film enlarged(const render::Film& film, const Crop& crop);

/// That part after each of some blurs of the whole image.
std::vector<render::Film> blurredCrops(const render::Film& film,
                                       const std::vector<render::GaussianBlur>& blurs,
                                       const Crop& crop);

} // namespace wellstrat::cli
