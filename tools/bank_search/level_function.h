// SPDX-License-Identifier: Apache-2.0
//
// What exact Owen scrambling makes of a function: E[f(p_i) f(p_j)] for two points of a scrambled
// digital sequence depends on nothing but the number of leading digits that the points share in
// each coordinate, and thereby on the one index n = i XOR j (Owen 1997, "Monte Carlo Variance of
// Scrambled Net Quadrature"). A LevelFunction is that expectation for all n in [0, 4096).
//
// For f on one domain and g on another, whose points are visited in the orders U and V,
//
//     E[(mean of f(p_i) g(q_i) over i < 2^m)^2] = 2^-m sum over n < 2^m of F(U n) G(V n),
//
// exactly and without a sample being drawn: that is what makes a search possible.

#pragma once

#include "bank_search/slot_order.h"

#include <functional>
#include <vector>

namespace wellstrat::bank {

using LevelFunction = std::vector<float>; ///< kPoints values

/// The share of level k of the variance of a function of one coordinate: of its differences between
/// the halves of dyadic intervals of length 2^(1-k); k = 0 is the square of the mean.
using Spectrum1D = std::function<double(unsigned k)>;

/// The same of levels k, l of a function of two coordinates.
using Spectrum2D = std::function<double(unsigned k, unsigned l)>;

/// Half of all patterns have the other order P U: these are means over the two.
LevelFunction levelFunction(const Spectrum2D& spectrum);  ///< of (x, y)
LevelFunction levelFunctionX(const Spectrum1D& spectrum); ///< of x alone
LevelFunction levelFunctionZ(const Spectrum1D& spectrum); ///< of z

/// The same for the mean over the 2^split samples of a visit to a slot under splitting, by the
/// number n of the visit.
LevelFunction levelFunction(const Spectrum2D& spectrum, unsigned split);
LevelFunction levelFunctionX(const Spectrum1D& spectrum, unsigned split);

/// Leading digits that two points with indices i, i XOR n share in x, y and z: up to kDigits.
unsigned sharedDigitsX(unsigned n);
unsigned sharedDigitsY(unsigned n);
unsigned sharedDigitsZ(unsigned n);

} // namespace wellstrat::bank
