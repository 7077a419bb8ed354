// SPDX-License-Identifier: Apache-2.0
//
// The error of pairs of slots for given integrands, squared over two domains, as a ratio to that of
// padding. As exact as the quadrature of the integrand, on a grid of 4096 x 4096.

#pragma once

#include "bank_search/insertion.h"
#include "wellstrat/analysis/integrands.h"

#include <array>

namespace wellstrat::bank {

/// By m, of 2^m points.
using ByDigits = std::array<double, kDigits + 1>;

struct Judgement {
    ByDigits mean;  ///< over all pairs, of the ratio of root mean squared errors
    ByDigits worst; ///< of all pairs
    /// What the root mean square of the ratios over all pairs is at least, for any matrices: the
    /// bank can only share out what a slot loses against itself. docs/joint.md has the proof.
    ByDigits bound;
};

/// `integrand` has one 2D domain; std::invalid_argument if not. The bank has two slots or more.
Judgement judge(const Bank& bank, const Integrand& integrand);

} // namespace wellstrat::bank
