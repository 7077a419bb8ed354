// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/geometry.h"

#include "point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr double kPi = 3.14159265358979323846;

double squaredDistance(const UnitPoints& points, std::size_t i, std::size_t j, Topology topology) {
    double sum = 0;
    for (unsigned d = 0; d < points.dims(); ++d) {
        double gap = std::fabs(points.coordinate(d)[i] - points.coordinate(d)[j]);
        if (topology == Topology::torus) gap = std::min(gap, 1 - gap);
        sum += gap * gap;
    }
    return sum;
}

/// Rings of cells around the point, until all further ones are too far away.
double nearestTo(std::size_t i, const UnitPoints& points, const PointGrid& grid,
                 Topology topology) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto consider = [&](std::size_t j) {
        if (j != i) nearest = std::min(nearest, squaredDistance(points, i, j, topology));
    };
    const long lastRing = topology == Topology::torus ? grid.side() / 2 : grid.side() - 1;
    for (long ring = 0; ring <= lastRing; ++ring) {
        const double reached = static_cast<double>(ring - 1) * grid.cellWidth();
        if (ring > 0 && nearest <= reached * reached) break;
        grid.visitRing(i, ring, topology, consider);
    }
    return std::sqrt(nearest);
}

/// The volume of a ball.
double ballVolume(double radius, unsigned dims) {
    switch (dims) {
    case 1: return 2 * radius;
    case 2: return kPi * radius * radius;
    default: return 4 * kPi / 3 * radius * radius * radius;
    }
}

void checkPairArguments(const UnitPoints& points, double range, unsigned bins) {
    if (points.dims() > kMaxPairDimensions) {
        throw PointError("the points have " + std::to_string(points.dims()) +
                         " dimensions; the pair correlation is there for 1 to " +
                         std::to_string(kMaxPairDimensions));
    }
    if (points.count() < 2) throw PointError("one point makes no pairs; accepted are two or more");
    if (!(range > 0 && range <= 0.5)) throw PointError("the range of distances is not in (0, 1/2]");
    if (bins == 0) throw PointError("the number of bins is 0; accepted are one or more");
}

} // namespace

NearestDistances nearestDistances(const UnitPoints& points, Topology topology) {
    const UnitPoints ordered = inCellOrder(points);
    const PointGrid grid(ordered);
    NearestDistances result{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < points.count(); ++i) {
        const double nearest = nearestTo(i, ordered, grid, topology);
        result.minimum = std::min(result.minimum, nearest);
        result.mean += nearest / static_cast<double>(points.count());
    }
    return result;
}

double largestMinimumDistance(std::size_t count, unsigned dims) {
    if (count == 0 || dims == 0 || dims > 3) {
        throw PointError(
            "the densest packing is there for one or more points in 1 to 3 dimensions");
    }
    const double volume = 1 / static_cast<double>(count);
    switch (dims) {
    case 1: return volume;
    case 2: return std::sqrt(2 / std::sqrt(3.0) * volume);
    default: return std::cbrt(std::sqrt(2.0) * volume);
    }
}

PairCorrelation pairCorrelation(const UnitPoints& points, double range, unsigned bins) {
    checkPairArguments(points, range, bins);
    const UnitPoints ordered = inCellOrder(points);
    const PointGrid grid(ordered);
    const double step = range / bins;
    std::vector<double> values(bins);
    const double farthest = range * range * (1 + 1e-12);
    const auto reach = static_cast<long>(std::ceil(range / grid.cellWidth()));
    for (std::size_t i = 0; i < points.count(); ++i) {
        grid.visitBox(i, reach, Topology::torus, [&](std::size_t j) {
            if (j >= i) return; // a pair is found from both of its points
            const double squared = squaredDistance(ordered, i, j, Topology::torus);
            if (squared > farthest) return;
            const double bin = std::sqrt(squared) / step;
            if (bin < bins) values[static_cast<std::size_t>(bin)] += 2;
        });
    }
    const auto count = static_cast<double>(points.count());
    for (unsigned k = 0; k < bins; ++k) {
        const double shell =
            ballVolume((k + 1) * step, points.dims()) - ballVolume(k * step, points.dims());
        values[k] /= count * (count - 1) * shell;
    }
    return {step, values};
}

double usualPairRange(std::size_t count, unsigned dims) {
    return std::min(0.5, 6 * std::pow(static_cast<double>(count), -1.0 / dims));
}

} // namespace stream1
} // namespace wellstrat
