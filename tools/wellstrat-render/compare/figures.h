// SPDX-License-Identifier: Apache-2.0
//
// The plots of wellstrat compare.

#pragma once

#include "common/output/picture.h"
#include "result.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

struct CompareFigure {
    std::string name;        ///< for files, such as "rmse-2px"
    std::string description; ///< for those who cannot see it
    Plot plot;
};

/// Error curves: plain, after each filter, relative, against time. Logarithmic axes need some
/// error: see `hasErrors`.
std::vector<CompareFigure> errorFigures(const Comparison& comparison);

/// Radial spectra of the errors, one for each number of samples.
std::vector<CompareFigure> spectrumFigures(const Comparison& comparison);

} // namespace wellstrat::cli
