// SPDX-License-Identifier: Apache-2.0

#include "figure.h"

#include "common/output/plot_data.h"
#include "strata_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace wellstrat::cli {
namespace {

constexpr unsigned kPanelWidth = 560;
constexpr unsigned kPanelHeight = 600;

/// Start and direction of the lines between the strata; more than some would be a gray area.
void writeGrid(PlotData& data, const StrataPanel& panel) {
    constexpr unsigned kMaxLines = 64;
    const unsigned columns = std::min(panel.columns, kMaxLines);
    const unsigned rows = std::min(panel.rows, kMaxLines);
    for (unsigned i = 0; i <= columns; ++i) data.line("{} 0 0 1", double(i) / columns);
    for (unsigned i = 0; i <= rows; ++i) data.line("0 {} 1 0", double(i) / rows);
}

/// From, to and the number of points of the 1D strata that hold any. Each stands apart from its
/// neighbors while there is room for that; beyond, equal neighbors are merged.
void writeStrata(PlotData& data, const PanelAxis& axis, unsigned count) {
    constexpr unsigned kMaxApart = 256;
    const double gap = count <= kMaxApart ? 0.08 : 0.0;
    const std::vector<unsigned> points = strataCounts(axis, count);
    for (unsigned begin = 0, end = 0; begin < count; begin = end) {
        end = begin + 1;
        while (count > kMaxApart && end < count && points[end] == points[begin]) ++end;
        if (points[begin] == 0) continue;
        data.line("{:.7f} {:.7f} {}", (begin + gap) / count, (end - gap) / count, points[begin]);
    }
}

void writeData(PlotData& data, const StrataPanel& panel, size_t number) {
    data.begin("grid", number);
    writeGrid(data, panel);
    data.begin("xstrata", number);
    writeStrata(data, panel.x, panel.strata);
    if (panel.planar) {
        data.begin("ystrata", number);
        writeStrata(data, panel.y, panel.strata);
    }
    data.begin("points", number);
    for (size_t i = 0; i < panel.x.values.size(); ++i) {
        data.line("{:.9g} {:.9g}", panel.x.values[i], panel.y.values[i]);
    }
}

/// "all 256 strata hold a point", or how many do.
std::string filled(const std::vector<unsigned>& counts, const char* what) {
    const auto empty = static_cast<size_t>(std::count(counts.begin(), counts.end(), 0u));
    const size_t all = counts.size();
    return empty == 0 ? fmt::format("all {} {} hold a point", all, what)
                      : fmt::format("{} of {} {} hold a point", all - empty, all, what);
}

constexpr auto kStyle = R"(set size ratio -1
set xrange [-0.05:1.01]
set yrange [-0.05:1.01]
unset border
unset tics
unset key
set bmargin 2.5
set tmargin 3.5
# Strips along the axes: a stratum with one point, with more, or (left out) with none.
color(points) = points == 1 ? 0x4477aa : 0xdd8833
)";

std::string axisLabel(const StrataPanel& panel, const PanelAxis& axis) {
    if (!panel.planar) return axis.name;
    return fmt::format("{}: {}", axis.name, filled(strataCounts(axis, panel.strata), "strata"));
}

/// The boxes of a strip; `places` says what they stand between in x and in y.
std::string stripCommand(const std::string& set, const char* places) {
    return fmt::format(
        "     data index '{}' using {}:(color($3)) with boxxyerror fs solid noborder "
        "lc rgb variable, \\\n",
        set, places);
}

std::string panelScript(const StrataPanel& panel, size_t number) {
    const double count = static_cast<double>(panel.x.values.size());
    std::string script;
    const auto out = std::back_inserter(script);
    fmt::format_to(out, "\nset title \"{{/:Bold {}}}\\n{}\"\n", panel.title,
                   filled(cellCounts(panel), panel.planar ? "squares" : "strata"));
    fmt::format_to(out, "set xlabel '{}'\n", axisLabel(panel, panel.x));
    fmt::format_to(out, "set ylabel '{}'\n", axisLabel(panel, panel.y));
    fmt::format_to(out, "plot data index 'grid{}' with vectors nohead lw 0.7 lc rgb 0xcccccc, \\\n",
                   number);
    script += stripCommand(fmt::format("xstrata{}", number), "1:(-0.03):1:2:(-0.042):(-0.018)");
    if (panel.planar) {
        script += stripCommand(fmt::format("ystrata{}", number), "(-0.03):1:(-0.042):(-0.018):1:2");
    }
    fmt::format_to(out, "     data index 'points{}' with points pt 7 ps {:.2f} lc rgb 0x222222\n",
                   number, std::clamp(12.0 / std::sqrt(count), 0.15, 1.2));
    return script;
}

} // namespace

Plot sampleFigure(const std::vector<SampleStream>& streams) {
    PlotData data;
    std::string panels;
    size_t count = 0;
    for (const SampleStream& stream : streams) {
        for (const StrataPanel& panel : strataPanels(stream)) {
            writeData(data, panel, count);
            panels += panelScript(panel, count);
            ++count;
        }
    }
    const size_t rows = streams.front().points.dims() >= 3 ? streams.size() : 1;
    const size_t columns = count / rows;
    const std::string script = fmt::format("{}set multiplot layout {},{}\n{}\nunset multiplot\n",
                                           kStyle, rows, columns, panels);
    return {script, data.take(), static_cast<unsigned>(columns) * kPanelWidth,
            static_cast<unsigned>(rows) * kPanelHeight};
}

std::vector<Plot> sampleFigures(const SampleStream& stream) {
    std::vector<Plot> plots;
    for (const StrataPanel& panel : strataPanels(stream)) {
        PlotData data;
        writeData(data, panel, 0);
        plots.push_back({kStyle + panelScript(panel, 0), data.take(), kPanelWidth, kPanelHeight});
    }
    return plots;
}

} // namespace wellstrat::cli
