// SPDX-License-Identifier: Apache-2.0
//
// Sums over all pairs of points of products of the smaller of their coordinates, without visiting
// all pairs. Heinrich 1996, "Efficient algorithms for computing the L2-discrepancy", Math. Comp.
// 65, 1621-1633: split the points along one axis; which of two points of different halves has the
// smaller coordinate is known then, and the axis leaves the problem.

#pragma once

#include "wellstrat/analysis/unit_points.h"

#include <cstddef>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

class MinimumSums {
public:
    /// The most axes in a product.
    static constexpr unsigned kMaxAxes = 3;

    /// Keeps a reference to `points`. Time: a sort along each axis. Memory: 8 bytes a coordinate.
    explicit MinimumSums(const UnitPoints& points);

    /// The sum over all ordered pairs (i, j), i = j among them, of
    ///
    ///     weights[i] weights[j] prod_(d in axes) min(1 - x_id, 1 - x_jd)
    ///
    /// with up to kMaxAxes different axes. Exact but for about 1e-17 of the sum of the weights'
    /// products. Time: count log2(count)^(axes - 1) steps. Memory: 64 bytes a point.
    long double sum(const std::vector<double>& weights, const std::vector<unsigned>& axes) const;

private:
    const UnitPoints& points_;
    std::vector<std::vector<std::size_t>> order_; ///< of the points along each axis, the last first
};

} // namespace stream1
} // namespace wellstrat
