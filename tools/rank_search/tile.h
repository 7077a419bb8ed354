// SPDX-License-Identifier: Apache-2.0
//
// A tile of ranks: toroidal, and nested like a quadtree, so that an aligned block of 2^a x 2^a
// pixels has an aligned run of 4^a ranks.

#pragma once

#include "rank_search/merit.h"

#include <random>
#include <vector>

namespace wellstrat::ranks {

/// The rank of pixel (x, y) of the tile is element y * kRankTileSize + x.
using Tile = std::vector<uint16_t>;

/// What a pair of pixels counts in the merit by their distance (dx, dy) on the torus, each in
/// [0, kRankTileSize), at dy * kRankTileSize + dx: 1 at (0, 0).
///
/// The autocorrelation of a Gaussian of sigma 2 pixels, and to a lesser share of sigma 1.
std::vector<float> window();

/// The squared error that a tile leaves after the filter, over that of independent pixels.
double tileMerit(const Tile& tile, const Covariance& covariance);

/// The share of the merit that the mean of the covariance over [4^l, 4^(l+1)) has in the mean over
/// all tiles that permute each node's children at random.
std::array<double, kRankDigits / 2> levelShares();

/// Each node's children in random order.
Tile randomTile(std::mt19937& random);

/// Such a tile with a low merit: annealed in `sweeps` sweeps of swaps of two children of a node.
Tile annealedTile(const Covariance& covariance, unsigned sweeps, std::mt19937& random);

} // namespace wellstrat::ranks
