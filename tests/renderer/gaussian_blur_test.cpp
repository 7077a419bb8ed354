// SPDX-License-Identifier: Apache-2.0

#include "renderer/gaussian_blur.h"

#include "hand_made_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace wellstrat::render {
namespace {

/// A picture of zeros with a 1 at (x, y), blurred.
std::vector<double> dotAt(unsigned x, unsigned y, double sigma, const PixelMask& mask) {
    std::vector<double> values(mask.counts.size());
    values[y * mask.width + x] = 1;
    GaussianBlur(sigma, mask).apply(values);
    return values;
}

double weight(int dx, int dy, double sigma) {
    return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
}

/// A dot becomes the Gaussian up to three standard deviations, here 4 pixels, with sum 1, where no
/// border is as near to what it reaches.
TEST(GaussianBlur, OfADot) {
    constexpr double kSigma = 1.5;
    const std::vector<double> values = dotAt(9, 8, kSigma, allPixels(19, 17));
    double all = 0, sum = 0;
    for (int dy = -4; dy <= 4; ++dy) {
        for (int dx = -4; dx <= 4; ++dx) all += weight(dx, dy, kSigma);
    }
    for (int y = 0; y < 17; ++y) {
        for (int x = 0; x < 19; ++x) {
            const bool near = std::abs(x - 9) <= 4 && std::abs(y - 8) <= 4;
            const double value = values[static_cast<std::size_t>(y * 19 + x)];
            EXPECT_NEAR(value, near ? weight(x - 9, y - 8, kSigma) / all : 0, 1e-15)
                << x << " " << y;
            sum += value;
        }
    }
    EXPECT_NEAR(sum, 1, 1e-14);
}

/// What is outside of the picture is not there: the weights of (1, 0) and its neighbors, by hand.
TEST(GaussianBlur, AtTheBorder) {
    const std::vector<double> values = dotAt(0, 0, 0.5, allPixels(9, 9)); // reaches 1 pixel
    const double one = std::exp(-2.0);
    EXPECT_NEAR(values[0], 1 / ((1 + one) * (1 + one)), 1e-15);
    EXPECT_NEAR(values[1], one / ((1 + 2 * one) * (1 + one)), 1e-15);
    EXPECT_NEAR(values[10], one * one / ((1 + 2 * one) * (1 + 2 * one)), 1e-15);
    EXPECT_EQ(values[2], 0);
}

/// The same for pixels outside of the mask: a row in which 1 and 2 do not count.
TEST(GaussianBlur, StaysInTheMask) {
    const PixelMask mask{5, 1, {1, 0, 0, 1, 1}};
    std::vector<double> values{4, 1000, 1000, 2, 3};
    GaussianBlur(1, mask).apply(values);
    const double w1 = std::exp(-0.5), w3 = std::exp(-4.5);
    EXPECT_NEAR(values[0], (4 + w3 * 2) / (1 + w3), 1e-15);
    EXPECT_EQ(values[1], 0);
    EXPECT_EQ(values[2], 0);
    EXPECT_NEAR(values[3], (w3 * 4 + 2 + w1 * 3) / (w3 + 1 + w1), 1e-15);
    EXPECT_NEAR(values[4], (w1 * 2 + 3) / (1 + w1), 1e-15);
}

/// Also where the blur reaches over all of the picture, and with holes.
TEST(GaussianBlur, KeepsConstants) {
    for (const double sigma : {0.1, 1.0, 2.0, 50.0}) {
        PixelMask mask = allPixels(11, 7);
        for (std::size_t i = 0; i < mask.counts.size(); i += 3) mask.counts[i] = 0;
        std::vector<double> values(mask.counts.size(), 0.7);
        GaussianBlur(sigma, mask).apply(values);
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_NEAR(values[i], mask.counts[i] ? 0.7 : 0, 1e-14) << sigma;
        }
    }
}

/// The difference of blurred pictures is the blurred difference.
TEST(GaussianBlur, IsLinear) {
    const auto a = [](unsigned x, unsigned y) { return Float3(float(x * y % 7), 1, float(x)); };
    const auto b = [](unsigned x, unsigned y) { return Float3(float(y), 2, float(x % 3)); };
    const Film filmA = imageOf(12, 10, a), filmB = imageOf(12, 10, b);
    const GaussianBlur blur(2, allPixels(12, 10));
    const Film blurredA = blurred(filmA, blur), blurredB = blurred(filmB, blur);
    for (int c = 0; c < 3; ++c) {
        std::vector<double> differences = meansOf(filmA, c);
        const std::vector<double> subtracted = meansOf(filmB, c);
        for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= subtracted[i];
        blur.apply(differences);
        const std::vector<double> left = meansOf(blurredA, c), right = meansOf(blurredB, c);
        for (std::size_t i = 0; i < differences.size(); ++i) {
            EXPECT_NEAR(left[i] - right[i], differences[i], 2e-6);
        }
    }
}

TEST(GaussianBlur, SizesMustBeEqual) {
    const GaussianBlur blur(2, allPixels(4, 4));
    std::vector<double> values(15);
    EXPECT_THROW(blur.apply(values), std::invalid_argument);
    EXPECT_THROW(blurred(Film(3, 5), blur), std::invalid_argument);
}

} // namespace
} // namespace wellstrat::render
