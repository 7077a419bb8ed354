// SPDX-License-Identifier: Apache-2.0
//
// Which pixels of a film are good enough: adaptive stopping by an error target.
//
// A pixel is done when the standard error of its mean luminance L, and those of the up to eight
// pixels around it within its tile, are at most target * (L + 0.01); the 0.01, in a picture where
// 1 is white, lets black pixels end. This is asked of a tile only when those of its pixels that
// are not done have 16, 32, 64, ... samples, and what is done stays so: the same samples are taken
// whatever the passes, threads and interruptions were, as a tile takes a pass whole or not at all.
//
// Two things to know. The samples that a pixel got decide whether it gets more, so pixels that
// missed a rare bright event stop early and too dark: the image is biased, the more so the larger
// the target is. And the error is estimated as if samples were independent, so stratified ones are
// better than it says.

#pragma once

#include "film.h"

#include <cstdint>
#include <vector>

namespace wellstrat::render {

/// Sets to 1 the entries of `done`, which has one for each pixel, row by row, of the pixels that
/// are done. `target` is above 0.
void markDonePixels(const Film& film, double target, std::vector<uint8_t>& done);

} // namespace wellstrat::render
