// SPDX-License-Identifier: Apache-2.0
//
// The picture of samples over their strata.

#pragma once

#include "common/output/picture.h"
#include "wellstrat/analysis/independence.h"

#include <vector>

namespace wellstrat::cli {

/// More points than this make no readable picture.
constexpr uint64_t kMaxFigurePoints = 65536;

/// Draws points of equal dimensions beside each other; those in 3D below each other, each as its
/// three 2D projections. Each panel shows the points over their finest square strata (for 1D: the
/// sample's position over its order) and along the axes which of the 1D strata hold no, one or more
/// points. The strata are those of the largest power of two that is not above their number.
Plot sampleFigure(const std::vector<SampleStream>& streams);

/// The same of one stream, a picture for each panel.
std::vector<Plot> sampleFigures(const SampleStream& stream);

} // namespace wellstrat::cli
