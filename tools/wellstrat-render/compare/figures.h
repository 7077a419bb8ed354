// SPDX-License-Identifier: Apache-2.0
//
// The plots of wellstrat compare.

#pragma once

#include "common/output/picture.h"
#include "result.h"

namespace wellstrat::cli {

/// Error curves. Logarithmic axes need some error: see `hasErrors`.
Plot errorFigure(const Comparison& comparison);

/// Radial spectra of the errors, a panel for each number of samples.
Plot spectrumFigure(const Comparison& comparison);

} // namespace wellstrat::cli
