// SPDX-License-Identifier: Apache-2.0
//
// The model functions of the search, by their spectra, and the products of their values at two
// points.

#pragma once

#include "bank_search/level_spectra.h"

#include <functional>
#include <vector>

namespace wellstrat::ranks {

/// Levels above count nothing.
constexpr unsigned kLevels = 12;

using Spectrum1D = std::function<double(unsigned k)>;
using Spectrum2D = std::function<double(unsigned k, unsigned l)>; ///< two coordinates

using levels::box;
using levels::edge;
using levels::smooth;
using levels::smooth1D;
using levels::step1D;

/// A spectrum of two coordinates as a sum of weight * of(k) * of(l).
struct SpectrumTerm {
    double weight;
    Spectrum1D of;
};

/// `edge`, by Cholesky's decomposition. What is left out has less than a thousandth of the
/// variance.
std::vector<SpectrumTerm> edgeTerms();

/// The expectation of the product of an Owen-scrambled function at two points that share the first
/// `digits` binary digits and not the next, for `digits` from 0 to kLevels: a difference of level k
/// is the same at both points if they share k digits, the opposite if k - 1, and independent if
/// less (Owen 1997, "Monte Carlo Variance of Scrambled Net Quadrature").
struct Products1D {
    explicit Products1D(const Spectrum1D& spectrum);
    double of[kLevels + 1];
};

/// The same by the digits that the points share in each of two coordinates.
struct Products2D {
    explicit Products2D(const Spectrum2D& spectrum);
    double of[kLevels + 1][kLevels + 1];
};

} // namespace wellstrat::ranks
