// SPDX-License-Identifier: Apache-2.0

#include "renderer/pixel_mask.h"

#include "hand_made_film.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wellstrat::render {
namespace {

bool counts(const PixelMask& mask, unsigned x, unsigned y) {
    return mask.counts[y * mask.width + x] != 0;
}

TEST(PixelMask, OfAllPixels) {
    const PixelMask mask = allPixels(5, 3);
    EXPECT_EQ(countOf(mask), 15u);
    EXPECT_EQ(countOf(smoothAreas(imageOf(5, 3, [](auto, auto) { return Float3(0.5f); }))), 15u);
}

/// A step between columns 9 and 10 is seen from two pixels on each side, whatever its color.
TEST(SmoothAreas, KeepAwayFromEdges) {
    for (int c = 0; c < 3; ++c) {
        const PixelMask mask = smoothAreas(imageOf(20, 6, [c](unsigned x, unsigned) {
            Float3 color(0.5f);
            if (x >= 10) color[c] = 0.7f;
            return color;
        }));
        for (unsigned y = 0; y < 6; ++y) {
            for (unsigned x = 0; x < 20; ++x) EXPECT_EQ(counts(mask, x, y), x < 8 || x > 11) << x;
        }
    }
}

/// So is a pixel of its own, in both directions, also at the border.
TEST(SmoothAreas, KeepAwayFromDots) {
    const PixelMask mask = smoothAreas(imageOf(
        9, 9, [](unsigned x, unsigned y) { return Float3(x == 4 && y == 0 ? 0.9f : 0.5f); }));
    for (unsigned y = 0; y < 9; ++y) {
        for (unsigned x = 0; x < 9; ++x) EXPECT_EQ(counts(mask, x, y), x < 2 || x > 6 || y > 2);
    }
}

/// (high - low) / (high + low + 0.02) = 0.1 where high = (1.1 low + 0.002) / 0.9.
TEST(SmoothAreas, BoundTheContrast) {
    const auto areaWith = [](float low, float high) {
        return countOf(smoothAreas(
            imageOf(5, 5, [=](unsigned x, unsigned) { return Float3(x == 2 ? high : low); })));
    };
    for (const float low : {0.001f, 1.0f, 1000.0f}) {
        const float limit = (1.1f * low + 0.002f) / 0.9f;
        EXPECT_EQ(areaWith(low, limit * 0.999f), 25u) << low;
        EXPECT_EQ(areaWith(low, limit * 1.001f), 0u) << low;
    }
}

/// Slow changes are smooth however large they are in sum: 1.5 % a pixel.
TEST(SmoothAreas, FollowSlopes) {
    EXPECT_EQ(
        countOf(smoothAreas(imageOf(
            200, 3, [](unsigned x, unsigned) { return Float3(std::pow(1.015f, float(x))); }))),
        600u);
}

} // namespace
} // namespace wellstrat::render
