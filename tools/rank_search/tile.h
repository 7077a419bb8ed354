// SPDX-License-Identifier: Apache-2.0
//
// A tile of ranks: toroidal, and nested like a quadtree, so that an aligned block of 2^a x 2^a
// pixels has an aligned run of 4^a ranks.

#pragma once

#include "rank_search/merit.h"

#include <functional>
#include <random>
#include <vector>

namespace wellstrat::ranks {

/// The rank of pixel (x, y) of the tile is element y * kRankTileSize + x.
using Tile = std::vector<uint16_t>;

/// What rho = r XOR r' counts in the merit, in [0, kRanks): the autocorrelation of the filter, 1
/// for a pixel and itself, added up over the pixels around one, averaged over all of them.
using Weights = std::vector<double>;

/// The filter is a Gaussian of sigma 2 pixels; to the share `narrow` of the merit, of sigma 1.
constexpr double kShareOfNarrow = 0.2;

Weights weightsOf(const Tile& tile, double narrow = kShareOfNarrow);

/// The mean over all tiles that permute each node's children at random.
Weights weightsOfRandomTiles(double narrow = kShareOfNarrow);

/// The squared error after the filter, over that of independent pixels.
double merit(const Weights& weights, const Covariance& covariance);

/// Each node's children in random order.
Tile randomTile(std::mt19937& random);

/// Such a tile with a low merit: annealed in `sweeps` sweeps of swaps of two children of a node.
/// Calls `swept` after each.
Tile annealedTile(const Covariance& covariance, unsigned sweeps, std::mt19937& random,
                  const std::function<void()>& swept);

} // namespace wellstrat::ranks
