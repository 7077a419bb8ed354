// SPDX-License-Identifier: Apache-2.0

#include "film_noise.h"

#include <algorithm>

namespace wellstrat::render {
namespace {

constexpr uint32_t kFirstDecision = 16;
constexpr double kDark = 0.01;

/// Pixels from (x0, y0) to (x1, y1), exclusive.
struct Rectangle {
    unsigned x0, y0, x1, y1;
};

template <typename Visit>
void visitPixels(const Rectangle& pixels, Visit&& visit) {
    for (unsigned y = pixels.y0; y < pixels.y1; ++y) {
        for (unsigned x = pixels.x0; x < pixels.x1; ++x) visit(x, y);
    }
}

bool isGood(const Film& film, double target, unsigned x, unsigned y) {
    const Float3 mean = film.mean(x, y);
    const double bright = luminance(double{mean.x}, double{mean.y}, double{mean.z});
    return double{film.standardError(x, y)} <= target * (bright + kDark);
}

bool neighborsAreGood(const Film& film, double target, const Rectangle& tile, unsigned x,
                      unsigned y) {
    const Rectangle near{std::max(x, tile.x0 + 1) - 1, std::max(y, tile.y0 + 1) - 1,
                         std::min(x + 2, tile.x1), std::min(y + 2, tile.y1)};
    bool good = true;
    visitPixels(near, [&](unsigned i, unsigned j) { good = good && isGood(film, target, i, j); });
    return good;
}

void markTile(const Film& film, double target, const Rectangle& tile, std::vector<uint8_t>& done) {
    uint32_t level = 0;
    visitPixels(tile,
                [&](unsigned x, unsigned y) { level = std::max(level, film.pixel(x, y).count); });
    const bool decides = level >= kFirstDecision && (level & (level - 1)) == 0;
    visitPixels(tile, [&](unsigned x, unsigned y) {
        // What has fewer samples than the tile was done before.
        if (film.pixel(x, y).count < level ||
            (decides && neighborsAreGood(film, target, tile, x, y))) {
            done[std::size_t{y} * film.width() + x] = 1;
        }
    });
}

} // namespace

void markDonePixels(const Film& film, double target, std::vector<uint8_t>& done) {
    for (unsigned y = 0; y < film.height(); y += kTileSize) {
        for (unsigned x = 0; x < film.width(); x += kTileSize) {
            markTile(film, target,
                     {x, y, std::min(x + kTileSize, film.width()),
                      std::min(y + kTileSize, film.height())},
                     done);
        }
    }
}

} // namespace wellstrat::render
