// SPDX-License-Identifier: Apache-2.0
//
// The variance of an integrand by levels, and the expectation that exact Owen scrambling makes of
// it; level_function.h has the same for model spectra.

#pragma once

#include "bank_search/level_function.h"
#include "wellstrat/analysis/integrand.h"

#include <string>
#include <vector>

namespace wellstrat::bank {

/// The share of the levels (k, l, j) of x, y and z in the mean square of an integrand of one domain
/// of 1D to 3D: of its Haar coefficients on boxes of 2^(1-k) x 2^(1-l) x 2^(1-j), where level 0 is
/// the mean over the axis. 1D samples are z. Measured on grids of 2^gridDigits points, 18 to 24;
/// with 24, in 2D, 4096 x 4096 and for levels above 12 of one axis 65536 x 256; in 3D, 256^3, 4096
/// x 64 x 64 and 65536 x 16 x 16 along each axis. Levels that no grid has count as nothing.
/// std::invalid_argument for several domains.
ByLevels levelShares(const Integrand& integrand, unsigned gridDigits = 24);

/// An integrand as the judge sees it.
struct JudgedIntegrand {
    std::string name;
    unsigned dims; ///< 1: a function of z, 2: of (x, y), 3: of (x, y, z)
    double squaredMean;
    /// E[f(p_i) f(p_j)] less the squared mean, by n = i XOR j in [0, kPoints); the mean over both
    /// orders that patterns have.
    std::vector<double> covariance;
};

JudgedIntegrand judgedIntegrand(const Integrand& integrand, unsigned gridDigits = 24);

} // namespace wellstrat::bank
