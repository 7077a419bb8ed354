// SPDX-License-Identifier: Apache-2.0

#include "figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wellstrat::cli {
namespace {

constexpr unsigned kPanelSize = 480;
void writePlane(PlotData& data, const PlaneSpectrum& plane, const UnitPoints& points,
                std::size_t number) {
    const double* x = points.coordinate(plane.projection[0]);
    const double* y = points.coordinate(plane.projection[1]);
    data.begin("points", number);
    for (std::size_t i = 0; i < points.count(); ++i) data.line("{:.9g} {:.9g}", x[i], y[i]);

    writePeriodogram(data, plane.periodogram, number);
    writeRadial(data, plane.radial, number);
}

std::string planeScript(const PlaneSpectrum& plane, const Measures& measures, std::size_t number) {
    const double pointSize = std::clamp(10.0 / std::sqrt(double(measures.count)), 0.1, 1.0);
    const int highest = shownFrequency(plane.periodogram);
    return fmt::format(
        "\nset size ratio -1\n"
        "set title '{0}: points'\n"
        "plot [0:1] [0:1] data index 'points{1}' with points pt 7 ps {2:.2f} lc rgb 0x222222\n"
        "set title '{0}: power of frequencies up to {3}'\n"
        "plot [-{4}:{4}] [-{4}:{4}] data index 'periodogram{1}' with image\n"
        "set size noratio\n"
        "set title '{0}: radial mean (line), anisotropy (dots), in dB'\n"
        "plot [0:{5}] [-40:20] data index 'radial{1}' using 1:2 with lines lw 2 lc rgb 0x4477aa, "
        "\\\n"
        "     data index 'radial{1}' using 1:3 with points pt 7 ps 0.3 lc rgb 0xdd8833\n",
        projectionName(plane.projection, measures.dims), number, pointSize, highest, highest + 0.5,
        plane.periodogram.maxFrequency());
}

constexpr auto kStyle =
    "unset key\n"
    "set tics nomirror\n"
    "set palette gray\n"
    "set cbrange [0:2]\n"
    "unset colorbox\n"
    "set grid lc rgb 0xdddddd\n";

constexpr auto kPairsScript =
    "\nset size noratio\n"
    "set title 'pair correlation by distance'\n"
    "plot [0:*] [0:*] data index 'pairs0' with lines lw 2 lc rgb 0x4477aa, 1 lc rgb 0x999999\n";

} // namespace

int shownFrequency(const Periodogram& periodogram) {
    constexpr int kMaxShown = 128;
    return std::min(periodogram.maxFrequency(), kMaxShown);
}

void writePeriodogram(PlotData& data, const Periodogram& periodogram, std::size_t number) {
    const int highest = shownFrequency(periodogram);
    data.begin("periodogram", number);
    for (int fy = -highest; fy <= highest; ++fy) {
        for (int fx = -highest; fx <= highest; ++fx) {
            data.line("{} {} {:.4g}", fx, fy, fx == 0 && fy == 0 ? 0.0 : periodogram.power(fx, fy));
        }
    }
}

void writeRadial(PlotData& data, const RadialSpectrum& radial, std::size_t number) {
    data.begin("radial", number);
    for (std::size_t r = 1; r < radial.mean.size(); ++r) {
        data.line("{} {:.3f} {:.3f}", r, decibels(radial.mean[r]), radial.anisotropyDb[r]);
    }
}

void writePairs(PlotData& data, const PairCorrelation& pairs, std::size_t number) {
    data.begin("pairs", number);
    for (std::size_t k = 0; k < pairs.values.size(); ++k) {
        data.line("{:.6g} {:.6g}", (static_cast<double>(k) + 0.5) * pairs.step, pairs.values[k]);
    }
}

Plot measuresFigure(const Measures& measures, const UnitPoints& points) {
    PlotData data;
    std::string panels;
    const std::size_t planes = std::min(measures.spectra.size(), kMaxFigureRows);
    for (std::size_t p = 0; p < planes; ++p) {
        writePlane(data, measures.spectra[p], points, p);
        panels += planeScript(measures.spectra[p], measures, p);
    }
    if (measures.pairs) {
        writePairs(data, *measures.pairs, 0);
        panels += kPairsScript;
    }
    const std::size_t columns = planes > 0 ? 3 : 1;
    const std::size_t rows = planes + (measures.pairs ? 1 : 0);
    const std::string script = fmt::format("{}set multiplot layout {},{}\n{}\nunset multiplot\n",
                                           kStyle, rows, columns, panels);
    return {script, data.take(), static_cast<unsigned>(columns) * kPanelSize,
            static_cast<unsigned>(rows) * kPanelSize};
}

} // namespace wellstrat::cli
