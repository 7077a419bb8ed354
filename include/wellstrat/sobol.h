// SPDX-License-Identifier: Apache-2.0
//
// The first three dimensions of the Sobol' sequence.
// Sobol' 1967, "On the distribution of points in a cube and the approximate evaluation of
// integrals"; primitive polynomials and initial direction numbers of Joe and Kuo 2008,
// "Constructing Sobol' sequences with better two-dimensional projections", table of file
// new-joe-kuo-6.21201, whose first three dimensions all published sets share.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

constexpr unsigned kSobolDimensions = 3;

/// A generator matrix over GF(2): column k, the direction number of index bit k, is what that bit
/// contributes to the point; bit 31 of a column is the coordinate's first binary digit.
struct SobolMatrix {
    uint32_t column[32];
};

/// The generator matrix of `dimension`, in [0, kSobolDimensions): dimension 0 is van der Corput's,
/// 1 has the primitive polynomial x + 1, 2 has x^2 + x + 1. Others give the one of dimension 2.
WELLSTRAT_HOST_DEVICE constexpr SobolMatrix sobolMatrix(unsigned dimension) {
    SobolMatrix matrix{};
    uint32_t* v = matrix.column;
    if (dimension == 0) {
        for (unsigned k = 0; k < 32; ++k) v[k] = 0x80000000u >> k;
        return matrix;
    }
    // Direction number k is m_k / 2^(k+1), m_k odd; v_k follows from the recurrence of the
    // polynomial (Joe and Kuo 2008, equation 2). Initial m: {1} and {1, 3}.
    const unsigned degree = dimension == 1 ? 1 : 2;
    v[0] = 0x80000000u;
    if (degree == 2) v[1] = 3u << 30;
    for (unsigned k = degree; k < 32; ++k) {
        v[k] = v[k - degree] ^ (v[k - degree] >> degree);
        if (degree == 2) v[k] ^= v[k - 1];
    }
    return matrix;
}

/// The coordinate of point `index` as a fraction of 2^32.
WELLSTRAT_HOST_DEVICE constexpr uint32_t sobolSample(const SobolMatrix& matrix, uint32_t index) {
    uint32_t value = 0;
    for (unsigned k = 0; index != 0; index >>= 1, ++k) {
        if (index & 1u) value ^= matrix.column[k];
    }
    return value;
}

/// Pascal's triangle modulo 2 times the bits of `index`: P[r][c] is binomial(c, r), 1 where the
/// bits of r are among those of c. Dimension 1 is dimension 0 of this product. Its own inverse: it
/// makes x of a point what y was, and y what x was.
WELLSTRAT_HOST_DEVICE constexpr uint32_t pascalTimes(uint32_t index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    return index ^ (index >> 16);
}

/// The same for dimension 2, as digits: bit r of the result is binary digit r of the coordinate of
/// point `index`, bit 0 the first. sobolSample(sobolMatrix(2), index) is this in opposite order.
///
/// Take the bits of the index as a polynomial f over GF(2) and write it in powers of
/// p = z^2 + z + 1, f = sum (a_l + b_l z) p^l. From the recurrence of the direction numbers, row 2l
/// of the matrix is the series of z^2l / p^(l+1) and row 2l + 1 that times z, so digit 2l is
/// a_l + b_l and digit 2l + 1 is b_l. Each step divides all polynomials of degree below 2n by
/// p^(n/2) = z^n + z^(n/2) + 1, for n = 16, 8, 4, 2.
WELLSTRAT_HOST_DEVICE constexpr uint32_t trinomialTimes(uint32_t index) {
    index ^= (index >> 8) & 0x00ffff00u;
    index ^= (index >> 16) & 0x000000ffu;
    index ^= (index >> 4) & 0x0ff00ff0u;
    index ^= (index >> 8) & 0x000f000fu;
    index ^= (index >> 2) & 0x3c3c3c3cu;
    index ^= (index >> 4) & 0x03030303u;
    index ^= (index >> 1) & 0x66666666u;
    index ^= (index >> 2) & 0x11111111u;
    return index ^ ((index >> 1) & 0x55555555u);
}

} // namespace stream1
} // namespace wellstrat
