// SPDX-License-Identifier: Apache-2.0
//
// Points by cells of a regular grid over their first coordinates, to find neighbors.

#pragma once

#include "wellstrat/analysis/unit_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

class PointGrid {
public:
    /// About one point a cell, and at least one cell.
    explicit PointGrid(const UnitPoints& points)
        : points_(points), axes_(std::min(points.dims(), kMaxAxes)),
          side_(sideOf(points.count(), axes_)), start_(power(side_, axes_) + 1),
          members_(points.count()) {
        const std::size_t cells = start_.size() - 1;
        for (std::size_t i = 0; i < points.count(); ++i) ++start_[cellOf(i) + 1];
        for (std::size_t c = 0; c < cells; ++c) start_[c + 1] += start_[c];
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < points.count(); ++i) members_[next[cellOf(i)]++] = i;
    }

    /// The numbers of the points, cell after cell.
    const std::vector<std::size_t>& members() const { return members_; }

    double cellWidth() const { return 1 / static_cast<double>(side_); }
    long side() const { return static_cast<long>(side_); }

    /// Calls visit(j) with every point of the cells that are `ring` cells away from that of point i
    /// along at least one axis and not more along any. On the torus, ring is at most side() / 2.
    template <class Visitor>
    void visitRing(std::size_t i, long ring, Topology topology, const Visitor& visit) const {
        visitAxis({i, ring, topology}, 0, 0, false, visit);
    }

    /// The same for the cells that are at most `reach` away along all axes; each once.
    template <class Visitor>
    void visitBox(std::size_t i, long reach, Topology topology, const Visitor& visit) const {
        visitAxis({i, reach, topology}, 0, 0, true, visit);
    }

private:
    static constexpr unsigned kMaxAxes = 3;

    static std::size_t sideOf(std::size_t count, unsigned axes) {
        return static_cast<std::size_t>(std::pow(static_cast<double>(count), 1.0 / axes) + 1e-9);
    }

    static std::size_t power(std::size_t base, unsigned exponent) {
        return exponent == 0 ? 1 : base * power(base, exponent - 1);
    }

    /// The product may round up to the side, though the coordinate is below 1.
    std::size_t place(std::size_t i, unsigned d) const {
        const double scaled = points_.coordinate(d)[i] * static_cast<double>(side_);
        return std::min(static_cast<std::size_t>(scaled), side_ - 1);
    }

    std::size_t cellOf(std::size_t i) const {
        std::size_t cell = 0;
        for (unsigned d = 0; d < axes_; ++d) cell = cell * side_ + place(i, d);
        return cell;
    }

    struct Around {
        std::size_t point;
        long reach;
        Topology topology;
    };

    /// Cells whose places along the axes before `axis` make up `cell`. Unless `all`, only those
    /// whose place along this axis or a later one is as far away as it may be.
    template <class Visitor>
    void visitAxis(const Around& around, unsigned axis, std::size_t cell, bool all,
                   const Visitor& visit) const {
        if (axis == axes_) return visitCells(cell, cell, visit);
        const bool torus = around.topology == Topology::torus;
        const long reach = around.reach;
        const long last = torus ? std::min(reach, side() - 1 - reach) : reach;
        if (axis + 1 == axes_ && all) {
            return visitRow(cell * side_, place(around.point, axis), {reach, last, torus}, visit);
        }
        const bool endsOnly = axis + 1 == axes_ && reach > 0;
        for (long offset = -reach; offset <= last; offset += endsOnly ? 2 * reach : 1) {
            long at = static_cast<long>(place(around.point, axis)) + offset;
            if (torus) at = (at % side() + side()) % side();
            if (at < 0 || at >= side()) continue;
            visitAxis(around, axis + 1, cell * side_ + static_cast<std::size_t>(at),
                      all || offset == -reach || offset == reach, visit);
        }
    }

    /// Cells of a row.
    struct Reach {
        long before, after;
        bool wraps;
    };

    /// The cells around place `at` of the row that begins with cell `row`, of which there are at
    /// most side().
    template <class Visitor>
    void visitRow(std::size_t row, std::size_t at, const Reach& reach, const Visitor& visit) const {
        const long first = static_cast<long>(at) - reach.before;
        const long last = static_cast<long>(at) + reach.after;
        const auto visitPart = [&](long from, long to) {
            from = std::max(from, 0L);
            to = std::min(to, side() - 1);
            if (from > to) return;
            visitCells(row + static_cast<std::size_t>(from), row + static_cast<std::size_t>(to),
                       visit);
        };
        visitPart(first, last);
        if (!reach.wraps) return;
        visitPart(first + side(), side() - 1);
        visitPart(0, last - side());
    }

    /// The cells `first` to `last`.
    template <class Visitor>
    void visitCells(std::size_t first, std::size_t last, const Visitor& visit) const {
        for (std::size_t k = start_[first]; k < start_[last + 1]; ++k) visit(members_[k]);
    }

    const UnitPoints& points_;
    unsigned axes_;
    std::size_t side_;
    std::vector<std::size_t> start_;   ///< of each cell in members_, and the end
    std::vector<std::size_t> members_; ///< points, cell after cell
};

/// The same points in the order of the cells, so that neighbors are neighbors in memory too.
inline UnitPoints inCellOrder(const UnitPoints& points) {
    const PointGrid grid(points);
    std::vector<double> values;
    values.reserve(points.count() * points.dims());
    for (const std::size_t i : grid.members()) {
        for (unsigned d = 0; d < points.dims(); ++d) values.push_back(points.coordinate(d)[i]);
    }
    return {values.data(), points.count(), points.dims()};
}

} // namespace stream1
} // namespace wellstrat
