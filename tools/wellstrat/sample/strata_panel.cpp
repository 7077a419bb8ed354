// SPDX-License-Identifier: Apache-2.0

#include "strata_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace wellstrat::cli {
namespace {

unsigned log2Floor(uint64_t n) {
    unsigned log = 0;
    while (n >>= 1) ++log;
    return log;
}

unsigned stratumOf(double value, unsigned count) { return static_cast<unsigned>(value * count); }

std::vector<PanelAxis> coordinateAxes(const UnitPoints& points) {
    std::vector<PanelAxis> axes;
    const char* const names = points.dims() == 1 ? "z" : "xyz";
    for (unsigned d = 0; d < std::min(points.dims(), 3u); ++d) {
        const double* const values = points.coordinate(d);
        axes.push_back({std::string(1, names[d]), {values, values + points.count()}});
    }
    return axes;
}

PanelAxis orderAxis(std::size_t count) {
    PanelAxis axis{"order of samples", {}};
    for (std::size_t i = 0; i < count; ++i) {
        axis.values.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    }
    return axis;
}

} // namespace

std::vector<StrataPanel> strataPanels(const SampleStream& stream) {
    const std::size_t count = stream.points.count();
    const unsigned m = log2Floor(count);
    const unsigned strata = 1u << m, side = 1u << (m / 2);
    const std::string title =
        fmt::format("{}: {} {}", stream.name, count, count == 1 ? "sample" : "samples");
    const std::vector<PanelAxis> axes = coordinateAxes(stream.points);
    if (axes.size() == 1) return {{title, axes[0], orderAxis(count), strata, strata, 1, false}};
    std::vector<StrataPanel> panels;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        for (std::size_t b = a + 1; b < axes.size(); ++b) {
            panels.push_back({title, axes[a], axes[b], strata, side, side, true});
        }
    }
    return panels;
}

std::vector<unsigned> strataCounts(const PanelAxis& axis, unsigned count) {
    std::vector<unsigned> counts(count);
    for (const double value : axis.values) ++counts[stratumOf(value, count)];
    return counts;
}

std::vector<unsigned> cellCounts(const StrataPanel& panel) {
    std::vector<unsigned> counts(panel.columns * panel.rows);
    for (size_t i = 0; i < panel.x.values.size(); ++i) {
        const unsigned column = stratumOf(panel.x.values[i], panel.columns);
        const unsigned row = stratumOf(panel.y.values[i], panel.rows);
        ++counts[row * panel.columns + column];
    }
    return counts;
}

} // namespace wellstrat::cli
