// SPDX-License-Identifier: Apache-2.0
//
// The model functions of searches, by their spectra (level_function.h). All have a mean of 1 beside
// what varies.

#pragma once

#include "bank_search/level_function.h"

#include <vector>

namespace wellstrat::bank {

double smooth(unsigned k, unsigned l); ///< differentiable
double edge(unsigned k, unsigned l);   ///< an edge at no particular angle
double box(unsigned k, unsigned l);    ///< a rectangle
double step(unsigned k, unsigned l);   ///< an edge along an axis

double smooth1D(unsigned k);
double step1D(unsigned k);

/// A spectrum of two coordinates of different domains as a sum of weight * of(k) * of(l).
struct SpectrumTerm {
    double weight;
    Spectrum1D of;
};

/// `edge`, by Cholesky's decomposition. What is left out has less than a thousandth of the
/// variance.
std::vector<SpectrumTerm> edgeTerms();

} // namespace wellstrat::bank
