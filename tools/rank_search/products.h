// SPDX-License-Identifier: Apache-2.0
//
// What exact Owen scrambling makes of a function in two pixels of a tile: E[f(p) f(p')], for the
// point p of place j in the pixel of rank q and p' of place j' in the pixel of rank q', depends on
// nothing but the digits that the points share, and so on j XOR j' and q XOR q' alone
// (wellstrat/rank.h).

#pragma once

#include "rank_search/spectra.h"
#include "wellstrat/rank.h"

#include <array>
#include <cstdint>
#include <vector>

namespace wellstrat::ranks {

/// What is sought is good for runs of 1, 2, 4 to kRun samples a pixel.
constexpr unsigned kRunDigits = 6;
constexpr unsigned kRun = 1u << kRunDigits;

/// The expectation for j XOR j' = n and q XOR q' = q is element n * kRanks + q. Means over the two
/// orders of x and y, each of which half of all domains have.
using Products = std::vector<double>;

Products productsXY(const Spectrum2D& spectrum);
Products productsX(const Spectrum1D& spectrum);

/// With `rankZ` for Dz: of z, of x or y and z, and of a function of (x, y) times one of z.
Products productsZ(const Spectrum1D& spectrum, const RankMatrix& rankZ);
Products productsXZ(const Spectrum2D& spectrum, const RankMatrix& rankZ);
Products productsXYZ(const Spectrum2D& ofXY, const Spectrum1D& ofZ, const RankMatrix& rankZ);

/// What makes the rank of a slot of that of a pixel, by its columns: column k is what bit k of the
/// pixel's rank adds.
using RankColumns = std::array<uint16_t, kRankDigits>;

/// How a domain visits the points of a tile: sample n of the pixel of rank r has place places[n]
/// and rank images[r].
struct Visits {
    std::vector<uint16_t> places; ///< kRun, of the first samples
    std::vector<uint16_t> images; ///< kRanks
};

/// Of slot `slot` of wellstrat/joint.h, whose ranks have these columns. Slot 0 with the columns of
/// the identity is also what padded domains are like: a nested shuffle of the samples changes no
/// sum over all pairs of them.
Visits visitsOf(unsigned slot, const RankColumns& columns);

RankColumns identityColumns();

/// The products for sample n of a domain, by images of ranks.
inline const double* rowOf(const Products& products, const Visits& visits, std::size_t n) {
    return products.data() + std::size_t{visits.places[n]} * kRanks;
}

} // namespace wellstrat::ranks
