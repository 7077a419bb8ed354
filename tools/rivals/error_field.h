// SPDX-License-Identifier: Apache-2.0
//
// The errors of the pixels of a tile, and the energy that is low if those of neighbors cancel.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace wellstrat::rivals {

constexpr unsigned kTileSize = 64; ///< pixels of a side; the tile is toroidal
constexpr unsigned kTilePixels = kTileSize * kTileSize;
constexpr unsigned kTileIntegrands = 32;
constexpr unsigned kTileLevels = 7; ///< of 1, 2, 4, ..., 64 samples
constexpr unsigned kTileErrors = kTileIntegrands * kTileLevels;

/// A pixel's estimates of all integrands, or their errors, or sums of such.
using TileErrors = std::array<float, kTileErrors>;

inline void addTimes(TileErrors& sum, float factor, const TileErrors& term) {
    for (unsigned h = 0; h < kTileErrors; ++h) sum[h] += factor * term[h];
}

/// a - b.
inline TileErrors difference(const TileErrors& a, const TileErrors& b) {
    TileErrors result = a;
    addTimes(result, -1, b);
    return result;
}

/// The energy is the sum over unordered pairs of pixels of exp(-d^2 / 3.5^2) error . error, where d
/// is their distance.
class ErrorField {
public:
    /// The errors of pixels 0 to kTilePixels - 1, row after row.
    explicit ErrorField(std::vector<TileErrors> errors);

    const TileErrors& operator[](unsigned pixel) const { return errors_[pixel]; }

    /// By how much the energy would rise if `change` were added to the errors of the pixel.
    double rise(unsigned pixel, const TileErrors& change) const;
    /// By how much it would rise if the two pixels exchanged their errors.
    double riseOfSwap(unsigned p, unsigned q) const;

    void add(unsigned pixel, const TileErrors& change);
    void swap(unsigned p, unsigned q);

private:
    static constexpr int kReach = 7; ///< pixels; the weights beyond are below 0.02
    static constexpr int kWidth = 2 * kReach + 1;

    /// Of two pixels that are this far apart; 0 for one and itself.
    float weight(int dx, int dy) const {
        return weights_[static_cast<unsigned>((dy + kReach) * kWidth + dx + kReach)];
    }
    void addToNeighbors(unsigned pixel, const TileErrors& change);

    std::array<float, std::size_t{kWidth} * kWidth> weights_;
    std::vector<TileErrors> errors_;
    std::vector<TileErrors> sums_; ///< over a pixel's neighbors, of weight x errors
};

} // namespace wellstrat::rivals
