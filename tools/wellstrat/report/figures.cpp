// SPDX-License-Identifier: Apache-2.0

#include "figures.h"

#include "analyze/figure.h"
#include "common/output/curve_style.h"
#include "common/output/plot_data.h"

#include <fmt/format.h>

#include <string>

namespace wellstrat::cli {
namespace {

constexpr auto kCurves = R"(set tics nomirror
set border 3
set grid lc rgb 0xdddddd lt 1
set autoscale xfix
)";

constexpr auto kPlanes = R"(set size ratio -1
unset key
unset colorbox
unset tics
set border lc rgb 0xbbbbbb
set palette gray
set cbrange [0:2]
)";

constexpr auto kBars = R"(set termoption noenhanced
unset key
set style fill solid noborder
set xlabel 'nanoseconds for a 2D sample'
set xrange [0:*]
set border 1
set tics nomirror scale 0
set grid xtics lc rgb 0xdddddd lt 1
set offsets 0, graph 0.08, 0, 0
)";

/// The range of the data, unless they have next to no power.
constexpr auto kDecibels = "[-60<*:*]";

constexpr unsigned kCurvesWidth = 600, kCurvesHeight = 460;

/// A plot command with a curve for each generator: column `column` of the set `set`.
std::string curves(const std::vector<ReportSubject>& subjects, const char* set, int column) {
    std::string text;
    for (std::size_t g = 0; g < subjects.size(); ++g) {
        text += fmt::format("{}data index '{}{}' using 1:{} with lines lw 1.8 {} title '{}'",
                            g == 0 ? "" : ", \\\n     ", set, g, column, curveStyle(g),
                            plainName(subjects[g].title));
    }
    return text + "\n";
}

/// Column `column` of the radial spectra of (x, y).
Plot ringsFigure(const std::vector<ReportSubject>& subjects, const char* title, int column) {
    PlotData data;
    for (std::size_t g = 0; g < subjects.size(); ++g) {
        writeRadial(data, subjects[g].inCube.spectra.front().radial, g);
    }
    return {fmt::format("{}{}set xlabel 'frequency'\nset title '{}'\nplot [] {} {}", kCurves,
                        kLegendBelow, title, kDecibels, curves(subjects, "radial", column)),
            data.take(), kCurvesWidth, kCurvesHeight};
}

} // namespace

Plot periodogramFigure(const ReportSubject& subject) {
    constexpr unsigned kPanelWidth = 250, kHeight = 320;
    const auto planes = static_cast<unsigned>(subject.inCube.spectra.size());
    PlotData data;
    std::string script =
        fmt::format("{}set multiplot layout 1,{} title '{}' noenhanced font ',24'\n", kPlanes,
                    planes, plainName(subject.title));
    for (unsigned p = 0; p < planes; ++p) {
        const PlaneSpectrum& plane = subject.inCube.spectra[p];
        writePeriodogram(data, plane.periodogram, p);
        script += fmt::format(
            "set title '{0}' font ',20'\nplot [-{2}:{2}] [-{2}:{2}] "
            "data index 'periodogram{1}' with image\n",
            projectionName(plane.projection, subject.inCube.dims), p,
            shownFrequency(plane.periodogram) + 0.5);
    }
    return {script + "unset multiplot\n", data.take(), planes * kPanelWidth, kHeight};
}

Plot radialFigure(const std::vector<ReportSubject>& subjects) {
    return ringsFigure(subjects, "radial mean (dB)", 2);
}

Plot anisotropyFigure(const std::vector<ReportSubject>& subjects) {
    return ringsFigure(subjects, "anisotropy (dB)", 3);
}

Plot pairsFigure(const std::vector<ReportSubject>& subjects) {
    PlotData data;
    for (std::size_t g = 0; g < subjects.size(); ++g) {
        writePairs(data, *subjects[g].inPlane.pairs, g);
    }
    const std::string script = fmt::format(
        "{}{}set xlabel 'distance'\nset title 'pair correlation of (x, y)'\n"
        "plot [] [0:2] {}",
        kCurves, kLegendBelow, curves(subjects, "pairs", 2));
    return {script, data.take(), kCurvesWidth, kCurvesHeight};
}

Plot speedFigure(const std::vector<BenchTime>& times) {
    PlotData data;
    data.begin("bars", 0);
    for (const BenchTime& time : times) {
        data.line("\"{}\" {:.4f} {}", plainName(time.name), time.median, time.isRival ? 1 : 0);
    }
    const auto rows = static_cast<unsigned>(times.size());
    const std::string script = fmt::format(
        "{}set yrange [{}:-0.7]\nset lmargin 34\n"
        "plot data index 'bars0' using ($2/2):0:($2/2):(0.34):($3 == 1 ? 0xbbbbbb : 0x4477aa)"
        ":ytic(1) with boxxyerror lc rgb variable, \\\n"
        "     data index 'bars0' using 2:0:(sprintf(' %.2f', $2)) with labels left\n",
        kBars, rows - 0.3);
    return {script, data.take(), 960, 90 + 26 * rows};
}

} // namespace wellstrat::cli
