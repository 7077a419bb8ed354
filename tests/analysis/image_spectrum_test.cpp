// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/image_spectrum.h"

#include "wellstrat/hash.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>
#include <vector>

namespace wellstrat {
namespace {

constexpr double kPi = 3.14159265358979323846;

template <class Value>
std::vector<double> imageOf(std::size_t width, std::size_t height, const Value& value) {
    std::vector<double> values;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) values.push_back(value(x, y));
    }
    return values;
}

/// Independent, from -1 to 1.
double noise(uint32_t seed, std::size_t x, std::size_t y) {
    return hashPair(hashPair(seed, static_cast<uint32_t>(x)), static_cast<uint32_t>(y)) * 0x1p-31 -
           1;
}

ImagePeriodogram periodogramOf(std::size_t width, std::size_t height,
                               const std::vector<double>& values) {
    ImagePeriodogram periodogram(width, height);
    periodogram.add(values);
    return periodogram;
}

/// Sides that are even, odd and 1.
TEST(ImagePeriodogram, IsTheDefinition) {
    for (const auto& [width, height] : {std::pair{6, 5}, {5, 6}, {7, 1}, {1, 4}, {1, 1}}) {
        const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
        const auto values = imageOf(w, h, [](auto x, auto y) { return noise(1, x, y); });
        const ImagePeriodogram found = periodogramOf(w, h, values);
        double squares = 0;
        for (const double value : values) squares += value * value;
        for (int fy = -height / 2; fy <= height / 2; ++fy) {
            for (int fx = -width / 2; fx <= width / 2; ++fx) {
                std::complex<double> sum = 0;
                for (int i = 0; i < width * height; ++i) {
                    const double turns =
                        double(fx * (i % width)) / width + double(fy * (i / width)) / height;
                    sum += std::polar(values[static_cast<std::size_t>(i)], -2 * kPi * turns);
                }
                EXPECT_NEAR(found.power(fx, fy), std::norm(sum) / squares, 1e-12)
                    << width << "x" << height << ": " << fx << " " << fy;
            }
        }
    }
}

/// Realizations count by their squares: those of a color without errors change nothing.
TEST(ImagePeriodogram, PoolsRealizations) {
    const auto a = imageOf(8, 8, [](auto x, auto y) { return noise(1, x, y); });
    const auto b = imageOf(8, 8, [](auto x, auto y) { return 3 * noise(2, x, y); });
    double ofA = 0, ofB = 0;
    for (const double value : a) ofA += value * value;
    for (const double value : b) ofB += value * value;
    ImagePeriodogram both = periodogramOf(8, 8, a);
    both.add(b);
    both.add(std::vector<double>(64));
    EXPECT_NEAR(
        both.power(2, -3),
        (periodogramOf(8, 8, a).power(2, -3) * ofA + periodogramOf(8, 8, b).power(2, -3) * ofB) /
            (ofA + ofB),
        1e-12);
    EXPECT_EQ(both.power(2, -3), both.power(-2, 3));
}

/// A wave has all of its power at two frequencies, half of the pixels each.
TEST(RadialPower, OfAWave) {
    const auto wave =
        imageOf(32, 16, [](auto x, auto) { return std::cos(2 * kPi * 6 * double(x) / 32); });
    const ImagePeriodogram found = periodogramOf(32, 16, wave);
    EXPECT_NEAR(found.power(6, 0), 256, 1e-9);
    const std::vector<RingPower> rings = radialPower(found);
    ASSERT_EQ(rings.size(), 8u); // 1/16 cycle wide; 6/32 is the middle of the third
    for (std::size_t r = 0; r < rings.size(); ++r) {
        EXPECT_DOUBLE_EQ(rings[r].frequency, double(r + 1) / 16);
        if (r == 2) continue;
        EXPECT_NEAR(rings[r].power, 0, 1e-9) << r;
    }
    // Of the frequencies (f / 32, g / 16), those whose length is within 1/32 of 3/16.
    int inRing = 0;
    for (int g = -7; g <= 8; ++g) {
        for (int f = -15; f <= 16; ++f) {
            const double length = 16 * std::hypot(f / 32.0, g / 16.0);
            if (length >= 2.5 && length < 3.5) ++inRing;
        }
    }
    EXPECT_NEAR(rings[2].power, 2 * 256.0 / inRing, 1e-9);
}

/// White noise is flat at 1, also where its variance differs or is 0. In 50 realizations the power
/// of a pair of opposite frequencies is a mean of 50 exponential variables, so a ring of n
/// frequencies has a standard error of (2 / (50 n))^(1/2). n is about 2 pi r: 2 rows of 24 rings
/// leave five of them once in 10^4 runs with other seeds.
TEST(RadialPower, OfWhiteNoise) {
    ImagePeriodogram everywhere(64, 48), somewhere(64, 48);
    for (uint32_t seed = 0; seed < 50; ++seed) {
        everywhere.add(imageOf(64, 48, [=](auto x, auto y) { return noise(seed, x, y); }));
        somewhere.add(imageOf(64, 48, [=](auto x, auto y) {
            return (x / 8 + y / 8) % 2 == 0 ? double(x) * noise(seed, x, y) : 0.0;
        }));
    }
    for (const auto& rings : {radialPower(everywhere), radialPower(somewhere)}) {
        ASSERT_EQ(rings.size(), 24u);
        for (std::size_t r = 0; r < rings.size(); ++r) {
            EXPECT_NEAR(rings[r].power, 1, 5 * std::sqrt(2 / (50 * 2 * kPi * double(r + 1)))) << r;
        }
    }
}

/// Noise minus its mean over the neighbors on a torus: at f, white noise times
/// (1 - cos(2 pi fx / 64) / 2 - cos(2 pi fy / 64) / 2)^2, whose mean over all f is 5 / 4.
TEST(RadialPower, OfBlueNoise) {
    ImagePeriodogram blue(64, 64);
    for (uint32_t seed = 0; seed < 50; ++seed) {
        blue.add(imageOf(64, 64, [=](std::size_t x, std::size_t y) {
            return noise(seed, x, y) -
                   (noise(seed, (x + 1) % 64, y) + noise(seed, (x + 63) % 64, y) +
                    noise(seed, x, (y + 1) % 64) + noise(seed, x, (y + 63) % 64)) /
                       4;
        }));
    }
    const std::vector<RingPower> rings = radialPower(blue);
    for (const std::size_t ring : {1u, 2u, 4u, 8u, 16u, 31u}) {
        double expected = 0;
        int count = 0;
        for (int fy = -31; fy <= 32; ++fy) {
            for (int fx = -31; fx <= 32; ++fx) {
                if (std::lround(std::hypot(fx, fy)) != static_cast<long>(ring)) continue;
                const double passes =
                    1 - std::cos(2 * kPi * fx / 64) / 2 - std::cos(2 * kPi * fy / 64) / 2;
                expected += passes * passes / 1.25;
                ++count;
            }
        }
        expected /= count;
        EXPECT_NEAR(rings[ring - 1].power, expected,
                    5 * 1.5 * expected * std::sqrt(2 / (50.0 * count)))
            << ring;
    }
    EXPECT_LT(rings[0].power, 1e-3);
}

TEST(RadialPower, OfNothing) {
    for (const RingPower& ring : radialPower(periodogramOf(9, 4, std::vector<double>(36)))) {
        EXPECT_EQ(ring.power, 0);
    }
    EXPECT_EQ(radialPower(periodogramOf(1, 1, {3})).at(0).power, 0); // there is only frequency 0
}

TEST(ImagePeriodogram, RejectsWhatItCannotDo) {
    EXPECT_THROW(ImagePeriodogram(0, 4), std::invalid_argument);
    EXPECT_THROW(ImagePeriodogram(4, 65537), std::invalid_argument);
    EXPECT_THROW(periodogramOf(3, 3, std::vector<double>(8)), std::invalid_argument);
}

} // namespace
} // namespace wellstrat
