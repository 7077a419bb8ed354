// SPDX-License-Identifier: Apache-2.0
//
// Sums of samples: the same bits in any order and split, and what they are read back as.

#include "renderer/film.h"

#include "RixRNGInline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Samples whose sum in floats or doubles depends on the order: 90 powers of two between them.
std::vector<Float3> wildSamples(unsigned count) {
    std::vector<Float3> samples;
    for (unsigned i = 0; i < count; ++i) {
        const auto wild = [i](unsigned c) {
            return std::ldexp(HashToRandom(i, c),
                              static_cast<int>(90 * HashToRandom(i, c + 3)) - 60);
        };
        samples.emplace_back(wild(0), wild(1), wild(2));
    }
    return samples;
}

Film filmOf(const std::vector<Float3>& samples) {
    Film film(1, 1);
    for (const Float3& sample : samples) film.add(0, 0, sample);
    return film;
}

/// Guards against sums that round.
TEST(Film, SumsDependNeitherOnOrderNorOnSplit) {
    std::vector<Float3> samples = wildSamples(1000);
    const Film inOrder = filmOf(samples);
    std::reverse(samples.begin(), samples.end());
    EXPECT_EQ(filmOf(samples).pixel(0, 0), inOrder.pixel(0, 0));
    for (const std::ptrdiff_t at : {0, 1, 377, 999, 1000}) {
        Film split = filmOf({samples.begin() + at, samples.end()});
        split.add(filmOf({samples.begin(), samples.begin() + at}));
        EXPECT_EQ(split.pixel(0, 0), inOrder.pixel(0, 0)) << at;
    }
}

TEST(Film, StartsBlack) {
    const Film film(3, 2);
    EXPECT_EQ(film.pixel(2, 1), PixelSums());
    EXPECT_EQ(film.mean(2, 1), Float3(0.0f));
    EXPECT_EQ(film.standardError(2, 1), kInfinity);
}

TEST(Film, PixelsAreSeparate) {
    Film film(3, 2);
    for (unsigned y = 0; y < 2; ++y) {
        for (unsigned x = 0; x < 3; ++x) film.add(x, y, Float3(static_cast<float>(10 * y + x)));
    }
    for (unsigned y = 0; y < 2; ++y) {
        for (unsigned x = 0; x < 3; ++x) {
            EXPECT_EQ(film.mean(x, y), Float3(static_cast<float>(10 * y + x)));
            EXPECT_EQ(film.pixel(x, y).count, 1u);
        }
    }
    EXPECT_EQ(film.pixels()[5], film.pixel(2, 1));
}

TEST(Film, MeanAndErrorAreThoseOfTheSamples) {
    const Film film = filmOf({{1, 10, 0.25f}, {3, 20, 0.5f}, {2, 60, 0.75f}});
    EXPECT_EQ(film.mean(0, 0), Float3(2, 30, 0.5f));
    std::vector<double> values;
    for (const Float3& s : {Float3(1, 10, 0.25f), Float3(3, 20, 0.5f), Float3(2, 60, 0.75f)}) {
        values.push_back(luminance(double{s.x}, double{s.y}, double{s.z}));
    }
    const double mean = (values[0] + values[1] + values[2]) / 3;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    EXPECT_NEAR(film.standardError(0, 0) / std::sqrt(squares / 2 / 3), 1, 1e-6);
}

TEST(Film, EqualSamplesHaveNoError) {
    EXPECT_LT(filmOf(std::vector<Float3>(100, Float3(0.7f))).standardError(0, 0), 1e-7f);
}

/// Never a NaN pixel.
TEST(Film, NotFiniteSamplesAreBlackAndCounted) {
    const Film film = filmOf({{kNan, 1, 1}, {1, kInfinity, 1}, {1, 1, -kInfinity}, Float3(4)});
    EXPECT_EQ(film.mean(0, 0), Float3(1));
    EXPECT_EQ(film.pixel(0, 0).count, 4u);
    EXPECT_EQ(film.pixel(0, 0).invalid, 3u);
    EXPECT_TRUE(std::isfinite(film.standardError(0, 0)));
}

TEST(Film, SamplesAreClamped) {
    const auto most = static_cast<float>(kMaxColor);
    const Film film = filmOf({{-1, std::numeric_limits<float>::max(), -0.0f}});
    EXPECT_EQ(film.mean(0, 0), Float3(0, most, 0));
    EXPECT_EQ(film.pixel(0, 0).invalid, 0u);
}

TEST(Film, SmallSamplesAreExactDownToTheUnit) {
    const float unit = std::ldexp(1.0f, -64);
    EXPECT_EQ(filmOf({Float3(3 * unit)}).mean(0, 0), Float3(3 * unit));
    EXPECT_EQ(filmOf({Float3(unit / 2)}).mean(0, 0), Float3(0));
    EXPECT_EQ(filmOf({Float3(1.75f * unit)}).mean(0, 0), Float3(unit));
}

/// The largest samples in the largest number: 2 + 4 + ... + 2^31 of them.
TEST(Film, SumsCannotOverflow) {
    Film film = filmOf({Float3(3e38f), Float3(3e38f)});
    Film sum = film;
    while (film.pixel(0, 0).count < 0x80000000u) {
        film.add(Film(film));
        sum.add(film);
    }
    EXPECT_EQ(sum.pixel(0, 0).count, 0xfffffffeu);
    EXPECT_EQ(sum.mean(0, 0), Float3(static_cast<float>(kMaxColor)));
    EXPECT_THROW(sum.add(filmOf({Float3(1), Float3(1)})), std::overflow_error);
}

TEST(Film, SizesAreChecked) {
    EXPECT_THROW(Film(0, 1), std::invalid_argument);
    EXPECT_THROW(Film(1, 0), std::invalid_argument);
    EXPECT_THROW(Film(65537, 1), std::invalid_argument);
    EXPECT_EQ(Film(65536, 1).width(), 65536u);
    EXPECT_THROW(Film(2, 1).add(Film(1, 2)), std::invalid_argument);
}

} // namespace
} // namespace wellstrat::render
