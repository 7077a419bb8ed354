// SPDX-License-Identifier: Apache-2.0

#include "strata_panel.h"

#include <fmt/format.h>

namespace wellstrat::cli {
namespace {

unsigned log2Floor(uint64_t n) {
    unsigned log = 0;
    while (n >>= 1) ++log;
    return log;
}

unsigned stratumOf(float value, unsigned count) {
    return static_cast<unsigned>(value * static_cast<float>(count));
}

std::vector<PanelAxis> coordinateAxes(const SampleRun& run) {
    std::vector<PanelAxis> axes;
    const char* const names = run.dims == 1 ? "z" : "xyz";
    for (unsigned d = 0; d < run.dims; ++d) axes.push_back({std::string(1, names[d]), {}});
    drawSamples(run, [&](const float* xi) {
        for (unsigned d = 0; d < run.dims; ++d) axes[d].values.push_back(xi[d]);
    });
    return axes;
}

PanelAxis orderAxis(uint64_t count) {
    PanelAxis axis{"order of samples", {}};
    for (uint64_t i = 0; i < count; ++i) {
        axis.values.push_back((static_cast<float>(i) + 0.5f) / static_cast<float>(count));
    }
    return axis;
}

} // namespace

std::vector<StrataPanel> strataPanels(const SampleRun& run) {
    const unsigned m = log2Floor(run.count);
    const unsigned strata = 1u << m, side = 1u << (m / 2);
    const std::string title = fmt::format("{}: {} {}", run.generator->name, run.count,
                                          run.count == 1 ? "sample" : "samples");
    const std::vector<PanelAxis> axes = coordinateAxes(run);
    if (run.dims == 1) return {{title, axes[0], orderAxis(run.count), strata, strata, 1, false}};
    std::vector<StrataPanel> panels;
    for (unsigned a = 0; a < run.dims; ++a) {
        for (unsigned b = a + 1; b < run.dims; ++b) {
            panels.push_back({title, axes[a], axes[b], strata, side, side, true});
        }
    }
    return panels;
}

std::vector<unsigned> strataCounts(const PanelAxis& axis, unsigned count) {
    std::vector<unsigned> counts(count);
    for (const float value : axis.values) ++counts[stratumOf(value, count)];
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
