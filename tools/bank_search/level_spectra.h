// SPDX-License-Identifier: Apache-2.0
//
// Kinds of functions by their spectra: what share of their variance is in the differences between
// the halves of dyadic intervals of length 2^(1-k), for each level k. Level 0 is the square of the
// mean, which is 1 for all of them. The searches for slots and for ranks know the same ones.

#pragma once

#include <algorithm>
#include <cmath>

namespace wellstrat::levels {

inline double powerOfTwo(int exponent) { return std::ldexp(1.0, exponent); }
inline int toInt(unsigned k) { return static_cast<int>(k); }

inline double smooth1D(unsigned k) { return powerOfTwo(-2 * toInt(k)); } ///< differentiable
inline double step1D(unsigned k) { return powerOfTwo(-toInt(k)); }

/// Of x and y; differentiable: 4^-(k+l), halved where both axes take part.
inline double smooth(unsigned k, unsigned l) {
    return powerOfTwo(-2 * toInt(k + l) - (k > 0 && l > 0 ? 1 : 0));
}

/// An edge at no particular angle.
inline double edge(unsigned k, unsigned l) {
    return powerOfTwo(toInt(std::min(k, l)) - 2 * toInt(std::max(k, l)));
}

/// A rectangle.
inline double box(unsigned k, unsigned l) { return powerOfTwo(-toInt(k + l)); }

} // namespace wellstrat::levels
