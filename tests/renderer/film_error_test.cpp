// SPDX-License-Identifier: Apache-2.0
//
// Errors of images against hand-made ones with known answers.

#include "renderer/film_error.h"

#include "RixRNGInline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace wellstrat::render {
namespace {

/// An image of one sample a pixel.
template <typename Color>
Film imageOf(unsigned width, unsigned height, Color color) {
    Film film(width, height);
    for (unsigned y = 0; y < height; ++y) {
        for (unsigned x = 0; x < width; ++x) film.add(x, y, color(x, y));
    }
    return film;
}

const auto kGray = [](unsigned, unsigned) { return Float3(0.5f); };

TEST(FilmError, IsZeroForEqualImages) {
    const FilmError error = filmError(imageOf(5, 7, kGray), imageOf(5, 7, kGray));
    EXPECT_EQ(error.rmse, 0);
    EXPECT_EQ(error.relativeMse, 0);
    EXPECT_EQ(error.filtered, 0);
}

/// A difference that is the same everywhere stays as it is under the blur, also at the edges.
TEST(FilmError, OfConstantDifferences) {
    const auto brighter = [](unsigned, unsigned) { return Float3(0.75f); };
    const FilmError error = filmError(imageOf(9, 30, brighter), imageOf(9, 30, kGray));
    EXPECT_DOUBLE_EQ(error.rmse, 0.25);
    EXPECT_NEAR(error.relativeMse, 0.0625 / 0.26, 1e-12);
    EXPECT_NEAR(error.filtered, 0.25, 1e-12);
}

TEST(FilmError, CountsEachColor) {
    const auto redder = [](unsigned, unsigned) { return Float3(1, 0.5f, 0.5f); };
    EXPECT_DOUBLE_EQ(filmError(imageOf(4, 4, redder), imageOf(4, 4, kGray)).rmse,
                     std::sqrt(0.25 / 3));
}

/// A single pixel spreads as a Gaussian: the sum of the squares of its weights is 1 / (4 pi s^2).
TEST(FilmError, FilterIsTheGaussian) {
    const auto dot = [](unsigned x, unsigned y) {
        return Float3(x == 20 && y == 20 ? 2.5f : 0.5f);
    };
    const FilmError error = filmError(imageOf(41, 41, dot), imageOf(41, 41, kGray));
    EXPECT_DOUBLE_EQ(error.rmse, 2.0 / 41);
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(error.filtered, 2.0 / 41 / std::sqrt(4 * pi * kErrorBlur * kErrorBlur), 2e-5);
}

/// What the filtered error is for: noise of neighbors that cancels counts less than white noise.
TEST(FilmError, FilterForgivesHighFrequencies) {
    const auto white = [](unsigned x, unsigned y) {
        return Float3(HashToRandom(x, y) < 0.5f ? 0.25f : 0.75f);
    };
    const auto checkered = [](unsigned x, unsigned y) {
        return Float3((x + y) % 2 == 0 ? 0.25f : 0.75f);
    };
    const Film reference = imageOf(64, 64, kGray);
    const FilmError ofWhite = filmError(imageOf(64, 64, white), reference);
    const FilmError ofCheckered = filmError(imageOf(64, 64, checkered), reference);
    EXPECT_DOUBLE_EQ(ofWhite.rmse, ofCheckered.rmse);
    EXPECT_LT(ofCheckered.filtered, 0.1 * ofWhite.filtered);
}

TEST(FilmError, SizesMustBeEqual) {
    EXPECT_THROW(filmError(Film(2, 3), Film(3, 2)), std::invalid_argument);
}

} // namespace
} // namespace wellstrat::render
