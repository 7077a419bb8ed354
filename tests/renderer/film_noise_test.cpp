// SPDX-License-Identifier: Apache-2.0
//
// Adaptive stopping: when pixels are done, and that it does not depend on the way there.

#include "renderer/film_noise.h"

#include "RixRNGInline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr unsigned kWidth = 40, kHeight = 20; // 3 x 2 tiles, some of them cut off

/// Noise grows to the right and downward.
Float3 sampleOf(unsigned x, unsigned y, unsigned i) {
    const float noise = static_cast<float>(x + 10 * (y / 4)) / 80;
    return Float3(0.5f + noise * (HashToRandom(y * kWidth + x, i) - 0.5f));
}

unsigned tileOf(unsigned x, unsigned y) { return y / kTileSize * 3 + x / kTileSize; }

/// Takes samples up to `end` of each pixel that is not done, but only in tiles below `endTile`.
void takePass(Film& film, double target, unsigned end, unsigned endTile = 6) {
    std::vector<uint8_t> done(film.pixels().size());
    markDonePixels(film, target, done);
    for (unsigned y = 0; y < kHeight; ++y) {
        for (unsigned x = 0; x < kWidth; ++x) {
            if (done[y * kWidth + x] != 0 || tileOf(x, y) >= endTile) continue;
            for (unsigned i = film.pixel(x, y).count; i < end; ++i) {
                film.add(x, y, sampleOf(x, y, i));
            }
        }
    }
}

Film rendered(double target, const std::vector<unsigned>& ends) {
    Film film(kWidth, kHeight);
    for (const unsigned end : ends) takePass(film, target, end);
    return film;
}

TEST(FilmNoise, NothingIsDoneBeforeSixteenSamples) {
    Film film(kWidth, kHeight);
    takePass(film, 1e6, 15);
    std::vector<uint8_t> done(film.pixels().size());
    markDonePixels(film, 1e6, done);
    EXPECT_EQ(std::count(done.begin(), done.end(), 1), 0);
    takePass(film, 1e6, 16);
    markDonePixels(film, 1e6, done);
    EXPECT_EQ(std::count(done.begin(), done.end(), 1), kWidth * kHeight);
}

TEST(FilmNoise, NoisyPixelsTakeMore) {
    const Film film = rendered(0.02, {16, 32, 64, 128, 256, 512, 1024});
    EXPECT_EQ(film.pixel(0, 0).count, 16u);
    EXPECT_GE(film.pixel(39, 19).count, 128u);
    for (unsigned y = 0; y < kHeight; ++y) {
        for (unsigned x = 0; x < kWidth; ++x) {
            if (film.pixel(x, y).count == 1024) continue;
            const double mean{film.mean(x, y).x};
            EXPECT_LE(film.standardError(x, y), 0.02 * (mean + 0.01)) << x << ' ' << y;
        }
    }
}

/// Guards against decisions that depend on where passes end, and on interruptions between tiles.
TEST(FilmNoise, PassesAndInterruptionsChangeNothing) {
    const Film whole = rendered(0.02, {1, 2, 4, 8, 16, 32, 64, 128, 256});
    EXPECT_TRUE(rendered(0.02, {3, 16, 20, 29, 32, 50, 64, 99, 128, 256}).pixels() ==
                whole.pixels());
    for (const unsigned endTile : {0u, 1u, 3u, 5u}) {
        Film film(kWidth, kHeight);
        for (const unsigned end : {16u, 32u, 40u, 64u, 128u, 256u}) {
            takePass(film, 0.02, end, endTile);
            takePass(film, 0.02, end);
        }
        EXPECT_TRUE(film.pixels() == whole.pixels()) << endTile;
    }
}

/// A black pixel beside bright ones has probably missed them.
TEST(FilmNoise, NeighborsInTheTileMustBeGoodToo) {
    Film film(kWidth, kHeight);
    for (unsigned i = 0; i < 16; ++i) {
        for (unsigned y = 0; y < kHeight; ++y) {
            for (unsigned x = 0; x < kWidth; ++x) {
                film.add(x, y, Float3(x == 15 && y == 8 && i == 3 ? 100.0f : 0.0f));
            }
        }
    }
    std::vector<uint8_t> done(film.pixels().size());
    markDonePixels(film, 0.1, done);
    EXPECT_EQ(std::count(done.begin(), done.end(), 0), 6); // the next column is another tile's
    for (const unsigned y : {7u, 8u, 9u}) {
        EXPECT_EQ(done[y * kWidth + 14], 0);
        EXPECT_EQ(done[y * kWidth + 15], 0);
    }
}

} // namespace
} // namespace wellstrat::render
