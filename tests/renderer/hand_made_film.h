// SPDX-License-Identifier: Apache-2.0
//
// Films with known contents.

#pragma once

#include "renderer/film.h"

namespace wellstrat::render {

/// An image of one sample a pixel, color(x, y).
template <typename Color>
Film imageOf(unsigned width, unsigned height, Color color) {
    Film film(width, height);
    for (unsigned y = 0; y < height; ++y) {
        for (unsigned x = 0; x < width; ++x) film.add(x, y, color(x, y));
    }
    return film;
}

} // namespace wellstrat::render
