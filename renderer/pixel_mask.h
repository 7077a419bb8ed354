// SPDX-License-Identifier: Apache-2.0
//
// Some of the pixels of a picture: those whose errors count.

#pragma once

#include "film.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::render {

struct PixelMask {
    unsigned width, height;
    std::vector<uint8_t> counts; ///< 1 for a pixel that counts, 0 for others, row by row
};

PixelMask allPixels(unsigned width, unsigned height);

/// How many pixels count.
std::size_t countOf(const PixelMask& mask);

/// What is near a pixel reaches this many pixels away, so within 5 x 5 of them: farther than the
/// pixel filter, so that a pixel which sees a silhouette has one beside it which sees less of it.
constexpr unsigned kSmoothReach = 2;

/// The most contrast of smooth areas.
constexpr double kSmoothContrast = 0.1;

/// The smooth areas of a picture: the pixels near which each color's contrast (max - min) / (max +
/// min + 0.02) is at most kSmoothContrast. The 0.02, in a picture where 1 is white, makes what is
/// nearly black smooth. Noise of the picture is contrast too.
PixelMask smoothAreas(const Film& film);

/// Reads a picture, in any format that OpenImageIO knows, whose pixels count that are not black.
/// Throws std::runtime_error with one line that says why it cannot be read.
PixelMask readMask(const std::string& path);

} // namespace wellstrat::render
