// SPDX-License-Identifier: Apache-2.0
//
// The generator matrices of the Sobol' sequence (sobol.h) times an index, without loops.
// Coordinates are words of digits whose bit 0 is the first one.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

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
