// SPDX-License-Identifier: Apache-2.0
//
// What exact Owen scrambling makes of a function: E[f(p_i) f(p_j)] for two points of a scrambled
// digital sequence depends on nothing but the number of leading digits that the points share in
// each coordinate, and thereby on the one index n = i XOR j (Owen 1997, "Monte Carlo Variance of
// Scrambled Net Quadrature"). A LevelFunction F is that expectation for all n in [0, 65536), as its
// part that varies about the square of the mean.
//
// For f on one domain and g on another, whose points are visited in the orders U and V,
//
//     E[(mean of f(p_i) g(q_i) over i < 2^m)^2] = 2^-m sum over n < 2^m of F(U n) G(V n),
//
// exactly and without a sample being drawn: that is what makes a search possible.

#pragma once

#include "bank_search/slot_order.h"

#include <array>
#include <functional>
#include <vector>

namespace wellstrat::bank {

/// By m, of 2^m points.
using ByDigits = std::array<double, kDigits + 1>;

/// Values by level, or by number of shared digits, of z, y and x: [z][y][x], each 0 to kDigits.
using ByLevels = std::array<std::array<std::array<double, kDigits + 1>, kDigits + 1>, kDigits + 1>;

/// The share of the levels k, l, j of x, y, z in the mean square of a function of a domain: of its
/// differences between the halves of dyadic intervals of length 2^(1-k), and so on; level 0 is the
/// mean over the axis, and (0, 0, 0) the square of the mean. A function does not depend on an axis
/// of which it has level 0 only.
using Spectrum = std::function<double(unsigned k, unsigned l, unsigned j)>;

ByLevels sharesOf(const Spectrum& spectrum);

struct LevelFunction {
    double squaredMean;
    std::vector<float> varying; ///< F(n) less the squared mean, kPoints values
    ByDigits sums;              ///< of what varies, over n < 2^m
};

/// F(n) less the squared mean, the share of level 0. Half of all patterns have the order P U
/// instead of U: this is the mean over the two.
std::vector<double> covariances(const ByLevels& shares);

LevelFunction levelFunction(const ByLevels& shares);

/// The same for the mean over the 2^split samples of a visit to a slot under splitting, by the
/// number n of the visit.
LevelFunction levelFunction(const ByLevels& shares, unsigned split);

/// The sums of values[n] over n < 2^m, as far as there are values.
template <typename Values>
ByDigits prefixSums(const Values& values) {
    ByDigits sums{};
    double sum = 0;
    for (unsigned m = 0, n = 0; m <= kDigits; ++m) {
        for (; n < 1u << m && n < values.size(); ++n) sum += double(values[n]);
        sums[m] = sum;
    }
    return sums;
}

} // namespace wellstrat::bank
