// SPDX-License-Identifier: Apache-2.0
//
// The first three dimensions of the Sobol' sequence.
// Sobol' 1967, "On the distribution of points in a cube and the approximate evaluation of
// integrals"; primitive polynomials and initial direction numbers of Joe and Kuo 2008,
// "Constructing Sobol' sequences with better two-dimensional projections", table of file
// new-joe-kuo-6.21201, whose first three dimensions all published sets share.

#pragma once

#include "wellstrat/platform.h"
#include "wellstrat/sobol_digits.h"

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

} // namespace stream1
} // namespace wellstrat
