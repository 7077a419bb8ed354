// SPDX-License-Identifier: Apache-2.0
//
// What one panel of the picture of samples shows, and how many points its strata hold.

#pragma once

#include "wellstrat/analysis/independence.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

/// One coordinate of all points of a panel, each in [0, 1).
struct PanelAxis {
    std::string name;
    std::vector<double> values;
};

/// Two coordinates of some points. The strata are those of the largest power of two, 2^m,
/// that is not above the number of points: `strata` = 2^m in 1D, `columns` x `rows` in 2D.
struct StrataPanel {
    std::string title;
    PanelAxis x, y;
    unsigned strata;
    unsigned columns, rows;
    bool planar; ///< y is a coordinate of the samples, not their order
};

/// 1D points over their order, 2D points in the plane, 3D points in three planes; of more
/// dimensions the planes of the first three.
std::vector<StrataPanel> strataPanels(const SampleStream& stream);

/// The number of points in each of `count` strata of an axis, and in each cell of a panel.
std::vector<unsigned> strataCounts(const PanelAxis& axis, unsigned count);
std::vector<unsigned> cellCounts(const StrataPanel& panel);

} // namespace wellstrat::cli
