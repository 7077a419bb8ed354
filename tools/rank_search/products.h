// SPDX-License-Identifier: Apache-2.0
//
// What exact Owen scrambling makes of a function in two pixels of a tile: E[f(p) f(p')], for the
// point p of place j in the pixel of rank q and p' of place j' in the pixel of rank q', depends on
// nothing but the digits that the points share, and so on j XOR j' and q XOR q' alone
// (wellstrat/rank.h, bank_search/level_function.h).

#pragma once

#include "bank_search/level_function.h"
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

Products productsXY(const bank::Spectrum2D& spectrum);
Products productsX(const bank::Spectrum1D& spectrum);
Products productsZ(const bank::Spectrum1D& spectrum);

/// The rank of a slot, by its columns: column k is what bit k of a pixel's rank adds to it.
using RankColumns = std::array<uint16_t, kRankDigits>;

/// The images of all ranks.
std::vector<uint16_t> imagesOf(const RankColumns& columns);

/// The places of the samples 0 to kRun - 1 of a slot of wellstrat/joint.h.
std::vector<uint16_t> placesOf(unsigned slot);

/// The same by samples and pixels: element n * kRanks + r is `products` at places[n] and images[r].
Products visited(const Products& products, const std::vector<uint16_t>& places,
                 const std::vector<uint16_t>& images);

} // namespace wellstrat::ranks
