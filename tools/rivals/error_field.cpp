// SPDX-License-Identifier: Apache-2.0

#include "error_field.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace wellstrat::rivals {
namespace {

double dot(const TileErrors& a, const TileErrors& b) {
    float sum = 0;
    for (unsigned h = 0; h < kTileErrors; ++h) sum += a[h] * b[h];
    return double(sum);
}

/// The way from one coordinate to another on the torus, in [-kTileSize / 2, kTileSize / 2).
int wayOnTorus(unsigned from, unsigned to) {
    constexpr unsigned kHalf = kTileSize / 2;
    return static_cast<int>((to - from + kHalf) % kTileSize) - static_cast<int>(kHalf);
}

} // namespace

ErrorField::ErrorField(std::vector<TileErrors> errors)
    : errors_(std::move(errors)), sums_(kTilePixels, TileErrors{}) {
    constexpr double kRadius = 3.5;
    for (int dy = -kReach; dy <= kReach; ++dy) {
        for (int dx = -kReach; dx <= kReach; ++dx) {
            const int squared = dx * dx + dy * dy;
            weights_[static_cast<unsigned>((dy + kReach) * kWidth + dx + kReach)] =
                squared == 0 ? 0 : static_cast<float>(std::exp(-squared / (kRadius * kRadius)));
        }
    }
    for (unsigned p = 0; p < kTilePixels; ++p) addToNeighbors(p, errors_[p]);
}

double ErrorField::rise(unsigned pixel, const TileErrors& change) const {
    return dot(change, sums_[pixel]);
}

double ErrorField::riseOfSwap(unsigned p, unsigned q) const {
    const TileErrors change = difference(errors_[q], errors_[p]);
    const int dx = wayOnTorus(p % kTileSize, q % kTileSize);
    const int dy = wayOnTorus(p / kTileSize, q / kTileSize);
    const bool near = std::abs(dx) <= kReach && std::abs(dy) <= kReach;
    const double between = near ? double(weight(dx, dy)) * dot(change, change) : 0;
    return dot(change, difference(sums_[p], sums_[q])) - between;
}

void ErrorField::add(unsigned pixel, const TileErrors& change) {
    addTimes(errors_[pixel], 1, change);
    addToNeighbors(pixel, change);
}

void ErrorField::swap(unsigned p, unsigned q) {
    const TileErrors atP = errors_[p], atQ = errors_[q];
    add(p, difference(atQ, atP));
    add(q, difference(atP, atQ));
    errors_[p] = atQ; // to the bit
    errors_[q] = atP;
}

void ErrorField::addToNeighbors(unsigned pixel, const TileErrors& change) {
    const unsigned x = pixel % kTileSize, y = pixel / kTileSize;
    for (int dy = -kReach; dy <= kReach; ++dy) {
        const unsigned row = (y + static_cast<unsigned>(dy)) % kTileSize * kTileSize;
        for (int dx = -kReach; dx <= kReach; ++dx) {
            const unsigned neighbor = row + (x + static_cast<unsigned>(dx)) % kTileSize;
            addTimes(sums_[neighbor], weight(dx, dy), change);
        }
    }
}

} // namespace wellstrat::rivals
