// SPDX-License-Identifier: Apache-2.0
//
// The picture of samples over their strata.

#pragma once

#include "picture.h"
#include "sampling.h"

#include <vector>

namespace wellstrat::cli {

/// More points than this make no readable picture.
constexpr uint64_t kMaxFigurePoints = 65536;

/// Draws runs of equal `dims` beside each other; those of 3D samples below each other, each as its
/// three 2D projections. Each panel shows the points over their finest square strata (for 1D: the
/// sample's position over its order) and along the axes which of the 1D strata hold no, one or more
/// points. The strata are those of the largest power of two that is not above `count`.
Plot sampleFigure(const std::vector<SampleRun>& runs);

} // namespace wellstrat::cli
