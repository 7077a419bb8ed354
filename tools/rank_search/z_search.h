// SPDX-License-Identifier: Apache-2.0
//
// Dz of wellstrat/rank.h. Z is upper triangular with a diagonal of ones, so z is stratified over
// runs of 2^k samples in blocks of 4^a pixels exactly if rows k to k + 2a - 1 of the first 2a
// columns of Dz are an invertible matrix. Many matrices have that for all k and a; the best of them
// is good for functions of z and one of x and y, and of all three.

#pragma once

#include "rank_search/tile.h"

#include <random>

namespace wellstrat::ranks {

/// Whether all of these blocks are invertible, up to the last of 32 rows.
bool stratifiesZ(const RankMatrix& matrix);

/// A random one for which this holds.
RankMatrix randomZ(std::mt19937& random);

/// The squared error of functions of z and others after the filter over that of independent pixels,
/// a mean over 1 to kRun samples a pixel.
double meritOfZ(const RankMatrix& matrix, const Weights& weights);

/// What the library's Dz is found with.
constexpr uint32_t kSeedOfZ = 1;

/// The best of `candidates` random ones.
RankMatrix searchZ(uint32_t seed = kSeedOfZ, unsigned candidates = 100);

} // namespace wellstrat::ranks
