// SPDX-License-Identifier: Apache-2.0

#include "common/output/curve_style.h"
#include "output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wellstrat::cli {
namespace {

constexpr unsigned kPanelWidth = 480;
constexpr unsigned kPanelHeight = 400;

constexpr auto kStyle = R"(set logscale xy
set format x '%g'
set format y '10^{%T}'
set grid lc rgb 0xdddddd lt 1
set xlabel 'points'
set ylabel 'RMSE'
set key bottom left samplen 2 spacing 1 noenhanced
set style fill transparent solid 0.2 noborder
)";

/// A logarithmic axis has no place for an error of 0.
std::string curveData(const StudyPlan& plan, const StudyCurve& curve) {
    std::string lines;
    for (std::size_t c = 0; c < plan.counts.size(); ++c) {
        const ErrorEstimate& error = curve.errors[c];
        if (!(error.rmse > 0)) continue;
        const bool banded = !std::isnan(error.low);
        fmt::format_to(std::back_inserter(lines), "{} {:.9g} {:.9g} {:.9g}\n", plan.counts[c],
                       error.rmse, banded ? error.low : error.rmse,
                       banded ? error.high : error.rmse);
    }
    return lines;
}

/// What draws curve `number` in color `place`; the last one of a panel ends the command.
std::string curveCommand(const StudyCurve& curve, std::size_t number, std::size_t place,
                         bool last) {
    return fmt::format(
        "     data index 'curve{0}' using 1:3:4 with filledcurves lc rgb {1} notitle, \\\n"
        "     data index 'curve{0}' using 1:2 with linespoints pt 7 ps 0.3 {2} title '{3}'{4}\n",
        number, curveColor(place), curveStyle(place), plainName(curve.source->name),
        last ? "" : ", \\");
}

} // namespace

Plot studyFigure(const StudyPlan& plan, const StudyResult& result,
                 const std::vector<StudyCurve>& curves) {
    const std::size_t panels = plan.integrands.size(), perPanel = plan.sources.size();
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(double(panels))));
    const std::size_t rows = (panels + columns - 1) / columns;
    std::string data, script = kStyle;
    fmt::format_to(std::back_inserter(script),
                   "set multiplot layout {},{} title '{}, 95 % bands'\n", rows, columns,
                   studyTitle(plan, result));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const StudyCurve& curve = curves[i];
        const std::size_t place = i % perPanel;
        if (place == 0) {
            script += fmt::format("\nset title '{}' noenhanced\nplot \\\n",
                                  plainName(curve.integrand->name));
        }
        fmt::format_to(std::back_inserter(data), "{}# curve{}\n{}", i == 0 ? "" : "\n\n", i,
                       curveData(plan, curve));
        script += curveCommand(curve, i, place, place + 1 == perPanel);
    }
    script += "\nunset multiplot\n";
    return {script, data, static_cast<unsigned>(columns) * kPanelWidth,
            static_cast<unsigned>(rows) * kPanelHeight};
}

} // namespace wellstrat::cli
