// SPDX-License-Identifier: Apache-2.0
//
// Distances between points: how close they come to each other, and how many lie how far apart.

#pragma once

#include "wellstrat/analysis/unit_points.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The distances of points to their nearest neighbors, Euclidean, in units of the cube's side.
/// Infinite if there is one point only.
struct NearestDistances {
    double minimum; ///< 0 if a point is there twice
    double mean;
};

/// Time: a few steps a point for evenly spread points; count^2 at worst. Cells are made of the
/// first three coordinates only, so more dimensions take longer. Memory: 16 bytes a point.
WELLSTRAT_API NearestDistances nearestDistances(const UnitPoints& points, Topology topology);

/// The largest minimum that `count` points on the torus can have: that of the densest packing of
/// spheres, which is known in one, two (hexagonal: Lagae, Dutre 2008, "A comparison of methods for
/// generating Poisson disk distributions", CGF 27, 114-129) and three dimensions (face-centered
/// cubic: Gamito, Maddock 2009, ACM TOG 29(1)). Throws PointError for others and for count 0.
WELLSTRAT_API double largestMinimumDistance(std::size_t count, unsigned dims);

/// The most dimensions for which `pairCorrelation` is there.
constexpr unsigned kMaxPairDimensions = 3;

/// How many pairs lie a distance apart, relative to independent uniform points, whose expectation
/// is exactly 1 everywhere.
struct PairCorrelation {
    double step;                ///< the width of a bin
    std::vector<double> values; ///< values[k]: distances in [k step, (k + 1) step)
};

/// On the torus, in one to three dimensions. `range`, in (0, 1/2], is split into `bins` >= 1.
/// Throws PointError for anything else and for less than two points.
/// Time: the number of pairs in range.
WELLSTRAT_API PairCorrelation pairCorrelation(const UnitPoints& points, double range,
                                              unsigned bins);

/// A range that shows what there is to see: six times the mean spacing count^(-1/dims), at most
/// 1/2.
WELLSTRAT_API double usualPairRange(std::size_t count, unsigned dims);

} // namespace stream1
} // namespace wellstrat
