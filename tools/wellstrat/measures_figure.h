// SPDX-License-Identifier: Apache-2.0
//
// The picture of measures: points and spectra.

#pragma once

#include "measures.h"
#include "picture.h"

#include <cstddef>

namespace wellstrat::cli {

/// A row for each 2D projection, at most kMaxFigureRows: its points, its periodogram, radial mean
/// and anisotropy; in the end the pair correlation. `points` are those of the first realization.
Plot measuresFigure(const Measures& measures, const UnitPoints& points);

constexpr std::size_t kMaxFigureRows = 6;

} // namespace wellstrat::cli
