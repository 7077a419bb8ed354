// SPDX-License-Identifier: Apache-2.0
//
// Errors of images against hand-made ones with known answers.

#include "renderer/film_error.h"

#include "RixRNGInline.h"
#include "hand_made_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace wellstrat::render {
namespace {

constexpr double kSigma = 2;

/// Of all pixels, with a blur of kSigma pixels.
FilmError errorOf(const Film& film, const Film& reference) {
    return filmError(film, reference,
                     errorMeasure(allPixels(film.width(), film.height()), {kSigma}));
}

const auto kGray = [](unsigned, unsigned) { return Float3(0.5f); };

TEST(FilmError, IsZeroForEqualImages) {
    const FilmError error = errorOf(imageOf(5, 7, kGray), imageOf(5, 7, kGray));
    EXPECT_EQ(error.rmse, 0);
    EXPECT_EQ(error.relativeMse, 0);
    EXPECT_EQ(error.filtered.at(0), 0);
}

/// A difference that is the same everywhere stays as it is under the blur, also at the edges.
TEST(FilmError, OfConstantDifferences) {
    const auto brighter = [](unsigned, unsigned) { return Float3(0.75f); };
    const FilmError error = errorOf(imageOf(9, 30, brighter), imageOf(9, 30, kGray));
    EXPECT_DOUBLE_EQ(error.rmse, 0.25);
    EXPECT_NEAR(error.relativeMse, 0.0625 / 0.26, 1e-12);
    EXPECT_NEAR(error.filtered.at(0), 0.25, 1e-12);
}

TEST(FilmError, CountsEachColor) {
    const auto redder = [](unsigned, unsigned) { return Float3(1, 0.5f, 0.5f); };
    EXPECT_DOUBLE_EQ(errorOf(imageOf(4, 4, redder), imageOf(4, 4, kGray)).rmse,
                     std::sqrt(0.25 / 3));
}

/// A single pixel spreads as a Gaussian: the sum of the squares of its weights is 1 / (4 pi s^2).
TEST(FilmError, FilterIsTheGaussian) {
    const auto dot = [](unsigned x, unsigned y) {
        return Float3(x == 20 && y == 20 ? 2.5f : 0.5f);
    };
    const FilmError error = errorOf(imageOf(41, 41, dot), imageOf(41, 41, kGray));
    EXPECT_DOUBLE_EQ(error.rmse, 2.0 / 41);
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(error.filtered.at(0), 2.0 / 41 / std::sqrt(4 * pi * kSigma * kSigma), 2e-5);
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
    const FilmError ofWhite = errorOf(imageOf(64, 64, white), reference);
    const FilmError ofCheckered = errorOf(imageOf(64, 64, checkered), reference);
    EXPECT_DOUBLE_EQ(ofWhite.rmse, ofCheckered.rmse);
    EXPECT_LT(ofCheckered.filtered.at(0), 0.1 * ofWhite.filtered.at(0));
}

/// Each blur has its error, and each is that of itself alone.
TEST(FilmError, OfSeveralBlurs) {
    const auto white = [](unsigned x, unsigned y) { return Float3(HashToRandom(x, y)); };
    const Film film = imageOf(16, 16, white), reference = imageOf(16, 16, kGray);
    const PixelMask all = allPixels(16, 16);
    const FilmError error = filmError(film, reference, errorMeasure(all, {0.1, 1, 2}));
    ASSERT_EQ(error.filtered.size(), 3u);
    EXPECT_DOUBLE_EQ(error.filtered[0], error.rmse); // a Gaussian of one pixel
    EXPECT_LT(error.filtered[2], error.filtered[1]);
    EXPECT_EQ(error.filtered[2], errorOf(film, reference).filtered[0]);
    EXPECT_TRUE(filmError(film, reference).filtered.empty());
}

/// What a mask leaves out may be anything, with blurs too.
TEST(FilmError, OfSomePixels) {
    PixelMask mask = allPixels(8, 4);
    for (std::size_t i = 0; i < 16; ++i) mask.counts[i] = 0; // the upper half
    const auto film = [](float above) {
        return imageOf(8, 4,
                       [above](unsigned, unsigned y) { return Float3(y < 2 ? above : 0.75f); });
    };
    for (const float above : {0.0f, 0.75f, 1000.0f}) {
        const FilmError error =
            filmError(film(above), imageOf(8, 4, kGray), errorMeasure(mask, {kSigma}));
        EXPECT_DOUBLE_EQ(error.rmse, 0.25);
        EXPECT_NEAR(error.relativeMse, 0.0625 / 0.26, 1e-12);
        EXPECT_NEAR(error.filtered.at(0), 0.25, 1e-12);
    }
    mask.counts.assign(32, 0);
    EXPECT_THROW(filmError(film(1), film(1), errorMeasure(mask, {})), std::invalid_argument);
}

/// Checkered errors are all at the highest frequency of both axes; the mask makes them 0.
TEST(AddErrors, OfCheckers) {
    const Film reference = imageOf(8, 8, kGray);
    const Film checkered = imageOf(8, 8, [](unsigned x, unsigned y) {
        return Float3((x + y) % 2 == 0 ? 0.25f : 0.75f, 0.5f, 0.5f);
    });
    ImagePeriodogram spectrum(8, 8), masked(8, 8);
    addErrors(checkered, reference, allPixels(8, 8), spectrum);
    EXPECT_NEAR(spectrum.power(4, 4), 64, 1e-9);
    EXPECT_NEAR(spectrum.power(3, 4), 0, 1e-9);
    addErrors(checkered, reference, {8, 8, std::vector<uint8_t>(64)}, masked);
    EXPECT_EQ(masked.power(4, 4), 0);
    EXPECT_THROW(addErrors(Film(2, 3), Film(3, 2), allPixels(2, 3), spectrum),
                 std::invalid_argument);
}

TEST(FilmError, SizesMustBeEqual) {
    EXPECT_THROW(filmError(Film(2, 3), Film(3, 2)), std::invalid_argument);
    EXPECT_THROW(filmError(Film(2, 3), Film(2, 3), errorMeasure(allPixels(3, 2), {})),
                 std::invalid_argument);
}

} // namespace
} // namespace wellstrat::render
