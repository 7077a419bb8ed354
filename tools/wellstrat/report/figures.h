// SPDX-License-Identifier: Apache-2.0
//
// The pictures of the report that compare generators.

#pragma once

#include "bench.h"
#include "common/output/picture.h"
#include "subject.h"

#include <vector>

namespace wellstrat::cli {

/// The periodograms of a generator's 2D projections beside each other, white from twice the power
/// of independent points on.
Plot periodogramFigure(const ReportSubject& subject);

/// Radial mean of (x, y), a curve for each generator.
Plot radialFigure(const std::vector<ReportSubject>& subjects);

/// Anisotropy of (x, y) by frequency, a curve for each generator.
Plot anisotropyFigure(const std::vector<ReportSubject>& subjects);

/// Pair correlation of (x, y), a curve for each generator.
Plot pairsFigure(const std::vector<ReportSubject>& subjects);

/// Times, such as those of 2D samples, as bars from top to bottom.
Plot speedFigure(const std::vector<BenchTime>& times);

} // namespace wellstrat::cli
