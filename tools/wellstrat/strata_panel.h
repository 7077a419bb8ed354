// SPDX-License-Identifier: Apache-2.0
//
// What one panel of the picture of samples shows, and how many points its strata hold.

#pragma once

#include "sampling.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

/// One coordinate of all points of a panel, each in [0, 1).
struct PanelAxis {
    std::string name;
    std::vector<float> values;
};

/// Two coordinates of the points of a run. The strata are those of the largest power of two, 2^m,
/// that is not above the number of points: `strata` = 2^m in 1D, `columns` x `rows` in 2D.
struct StrataPanel {
    std::string title;
    PanelAxis x, y;
    unsigned strata;
    unsigned columns, rows;
    bool planar; ///< y is a coordinate of the samples, not their order
};

/// 1D samples over their order, 2D samples in the plane, 3D samples in three planes.
std::vector<StrataPanel> strataPanels(const SampleRun& run);

/// The number of points in each of `count` strata of an axis, and in each cell of a panel.
std::vector<unsigned> strataCounts(const PanelAxis& axis, unsigned count);
std::vector<unsigned> cellCounts(const StrataPanel& panel);

} // namespace wellstrat::cli
