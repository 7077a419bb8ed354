// SPDX-License-Identifier: Apache-2.0
//
// The picture of measures: points and spectra.

#pragma once

#include "common/output/picture.h"
#include "common/output/plot_data.h"
#include "measures.h"

#include <cstddef>

namespace wellstrat::cli {

/// A row for each 2D projection, at most kMaxFigureRows: its points, its periodogram, radial mean
/// and anisotropy; in the end the pair correlation. `points` are those of the first realization.
Plot measuresFigure(const Measures& measures, const UnitPoints& points);

constexpr std::size_t kMaxFigureRows = 6;

/// The sets of data of which pictures of measures consist. "periodogram": fx, fy and power of the
/// frequencies with components up to shownFrequency(). "radial": frequency, mean power and
/// anisotropy in dB. "pairs": distance and pair correlation.
void writePeriodogram(PlotData& data, const Periodogram& periodogram, std::size_t number);
void writeRadial(PlotData& data, const RadialSpectrum& radial, std::size_t number);
void writePairs(PlotData& data, const PairCorrelation& pairs, std::size_t number);
int shownFrequency(const Periodogram& periodogram);

} // namespace wellstrat::cli
