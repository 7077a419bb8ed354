// SPDX-License-Identifier: Apache-2.0
//
// What the rank of a pixel adds to its points, so that neighbours are stratified together.
//
// Pixels are ranked by a quadtree: an aligned block of 2^a x 2^a pixels has an aligned run of 4^a
// ranks. With the digits of x, y and z of a point as vectors over GF(2), bit b being binary digit b
// behind the point, the point of place j in the pixel of rank r has the digits
//
//     x = j ^ Dx r        y = P j ^ Dy r        z = Z j ^ Dz r
//
// P is Pascal's triangle and Z the matrix of Sobol' dimension 2. j and r together are the
// coefficients of a function
//
//     f = sum over b of j_b z^b  +  sum over l of (r_2l + r_(2l+1) z) / (1 + z + z^2)^(l+1)
//
// over GF(2), and x and y the coefficients of its expansions around 0 and 1. For places below 2^k
// and ranks below 4^a, f is N / (1 + z + z^2)^a with a polynomial N of degree below k + 2a. If q1
// digits of x and q2 of y vanish, q1 + q2 = k + 2a, then z^q1 (1 + z)^q2 divides N, so N is 0: the
// points are a (0, k + 2a, 2)-net. Other runs and blocks add a constant, which keeps nets. The
// places of a rational function field make nets since Niederreiter and Xing 1996, "Low-Discrepancy
// Sequences and Global Function Fields with Many Rational Places". Dz does it for z alone.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// Ranks have so many binary digits, two for each level of the quadtree: those of a tile of
/// kRankTileSize x kRankTileSize pixels.
constexpr unsigned kRankDigits = 12;
constexpr unsigned kRankTileSize = 64;
constexpr unsigned kRanks = 1u << kRankDigits;

/// A matrix over GF(2): column k is what bit k of a rank adds to a coordinate, bit b of a column
/// being binary digit b, the first of all at b = 0.
struct RankMatrix {
    uint32_t column[kRankDigits];
};

namespace detail {

/// Dz, as `wellstrat ranks --z` prints it.
inline constexpr RankMatrix kRankZ = {{0xb6bfeddf, 0x6deabb6a, 0x22d9111b, 0x3e488e27, 0xbc20ebd1,
                                       0x183839e6, 0x149ba4a6, 0xe2b2ab70, 0x33c0b040, 0xbe7f12a7,
                                       0xc46e7929, 0x17d34465}};

/// The power series `series` / (1 + z + z^2), bit b being the coefficient of z^b.
WELLSTRAT_HOST_DEVICE constexpr uint32_t dividedByPole(uint32_t series) {
    for (unsigned b = 0; b < 31; ++b) {
        if (series >> b & 1u) series ^= (b < 30 ? 6u : 2u) << b;
    }
    return series;
}

} // namespace detail

/// Dx, Dy or Dz, for `dimension` 0, 1 or 2. Others give the last.
WELLSTRAT_HOST_DEVICE constexpr RankMatrix rankMatrix(unsigned dimension) {
    if (dimension > 1) return detail::kRankZ;
    RankMatrix matrix{};
    uint32_t power = 1;
    for (unsigned l = 0; l < kRankDigits / 2; ++l) {
        power = detail::dividedByPole(power);
        // z around 1 is 1 + z, and 1 + z + z^2 is what it was.
        matrix.column[2 * l] = power;
        matrix.column[2 * l + 1] = dimension == 0 ? power << 1 : power ^ (power << 1);
    }
    return matrix;
}

/// The matrix times the bits of `rank`, below kRanks.
WELLSTRAT_HOST_DEVICE constexpr uint32_t rankTimes(const RankMatrix& matrix, uint32_t rank) {
    uint32_t digits = 0;
    for (unsigned k = 0; rank != 0; rank >>= 1, ++k) {
        if (rank & 1u) digits ^= matrix.column[k];
    }
    return digits;
}

} // namespace stream1
} // namespace wellstrat
