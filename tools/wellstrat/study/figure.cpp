// SPDX-License-Identifier: Apache-2.0

#include "common/output/axes.h"
#include "common/output/curve_style.h"
#include "common/output/readable_names.h"
#include "output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wellstrat::cli {
namespace {

constexpr unsigned kPanelWidth = 480;
constexpr unsigned kPanelHeight = 340;
constexpr unsigned kLegendLine = 20;

constexpr auto kStyle = R"(set grid lc rgb 0xdddddd lt 1
set xlabel 'points'
set ylabel 'RMSE'
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
        number, curveColor(place), curveStyle(place), plainName(generatorTitle(curve.source->name)),
        last ? "" : ", \\");
}

/// Axes, title and curves of the integrand whose curves begin at `first`, which adds their data.
std::string panelScript(const StudyPlan& plan, const std::vector<StudyCurve>& curves,
                        std::size_t first, std::string& data) {
    const std::size_t sources = plan.sources.size();
    AxisRange x, y;
    std::string commands;
    for (std::size_t place = 0; place < sources; ++place) {
        const StudyCurve& curve = curves[first + place];
        fmt::format_to(std::back_inserter(data), "{}# curve{}\n{}", data.empty() ? "" : "\n\n",
                       first + place, curveData(plan, curve));
        commands += curveCommand(curve, first + place, place, place + 1 == sources);
        for (std::size_t c = 0; c < plan.counts.size(); ++c) {
            const ErrorEstimate& error = curve.errors[c];
            x.add(plan.counts[c]);
            for (const double value : {error.rmse, error.low, error.high}) y.add(value);
        }
    }
    return fmt::format("\nset title '{}' noenhanced\n{}{}plot \\\n{}",
                       plainName(integrandTitle(curves[first].integrand->name)),
                       doublingAxis("x", x), decimalAxis("y", y), commands);
}

unsigned panelHeight(const StudyPlan& plan) {
    return kPanelHeight + kLegendLine * static_cast<unsigned>(plan.sources.size());
}

} // namespace

Plot studyFigure(const StudyPlan& plan, const StudyResult& result,
                 const std::vector<StudyCurve>& curves) {
    const std::size_t panels = plan.integrands.size();
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(double(panels))));
    const std::size_t rows = (panels + columns - 1) / columns;
    std::string data, script = kStyle + std::string(kLegendBelow);
    fmt::format_to(std::back_inserter(script),
                   "set multiplot layout {},{} title '{}, 95 % bands'\n", rows, columns,
                   studyTitle(plan, result));
    for (std::size_t first = 0; first < curves.size(); first += plan.sources.size()) {
        script += panelScript(plan, curves, first, data);
    }
    script += "\nunset multiplot\n";
    return {script, data, static_cast<unsigned>(columns) * kPanelWidth,
            static_cast<unsigned>(rows) * panelHeight(plan)};
}

Plot studyPanel(const StudyPlan& plan, const std::vector<StudyCurve>& curves, std::size_t first) {
    std::string data;
    const std::string script =
        kStyle + std::string(kLegendBelow) + panelScript(plan, curves, first, data);
    return {script, data, kPanelWidth, panelHeight(plan)};
}

} // namespace wellstrat::cli
