// SPDX-License-Identifier: Apache-2.0

#include "figures.h"

#include "common/output/curve_style.h"
#include "common/output/plot_data.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kErrorStyle = R"(set logscale xy
set format x '%g'
set format y '10^{%T}'
set grid lc rgb 0xdddddd lt 1
set key top right samplen 2 spacing 1 noenhanced
)";

constexpr auto kSpectrumStyle = R"(set xrange [0:0.5]
set yrange [0:2<*]
set xlabel 'cycles a pixel'
set grid lc rgb 0xdddddd lt 1
set key bottom right samplen 2 spacing 1 noenhanced
)";

constexpr unsigned kErrorColumns = 2, kSpectrumColumns = 3;
constexpr unsigned kFigureWidth = 960, kPanelHeight = 380;

struct Panel {
    std::string title, xLabel;
    std::size_t x, y; ///< columns of the data
};

/// Columns 1 to 4 of the data are samples, RMSE, relative MSE, seconds; then filtered ones.
std::vector<Panel> errorPanels(const Comparison& comparison) {
    std::vector<Panel> panels{{"RMSE", "samples of a pixel", 1, 2}};
    for (const render::GaussianBlur& blur : comparison.measure.blurs) {
        panels.push_back({"RMSE after a Gaussian of " + filterName(blur.sigma()),
                          "samples of a pixel", 1, 4 + panels.size()});
    }
    panels.push_back({"relative MSE", "samples of a pixel", 1, 3});
    panels.push_back({"RMSE against time", "seconds", 4, 2});
    return panels;
}

/// The curves of all generators from the sets `first`, `first` + 1, ... of the data.
std::string curves(const Comparison& comparison, std::size_t first, std::size_t x, std::size_t y,
                   const char* points) {
    std::string text;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        text += fmt::format("{}data index 'curve{}' using {}:{} with {} {} title '{}'",
                            i == 0 ? "" : ", \\\n     ", first + i, x, y, points, curveStyle(i),
                            plainName(comparison.generators[i].name));
    }
    return text;
}

/// All panels, `columns` of them beside each other.
Plot figureOf(const std::string& style, const std::vector<std::string>& panels, std::size_t columns,
              std::string data) {
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    std::string script = fmt::format("{}set multiplot layout {},{}\n", style, rows, columns);
    for (const std::string& panel : panels) script += panel;
    script += "\nunset multiplot\n";
    return {script, std::move(data), kFigureWidth, static_cast<unsigned>(rows) * kPanelHeight};
}

} // namespace

Plot errorFigure(const Comparison& comparison) {
    PlotData data;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        data.begin("curve", i);
        for (const ComparedImage& image : comparison.generators[i].images) {
            std::string filtered;
            for (const double error : image.error.filtered) {
                filtered += fmt::format(" {:.9g}", error);
            }
            data.line("{} {:.9g} {:.9g} {:.9g}{}", image.samples, image.error.rmse,
                      image.error.relativeMse, image.seconds, filtered);
        }
    }
    std::vector<std::string> panels;
    for (const Panel& panel : errorPanels(comparison)) {
        panels.push_back(
            fmt::format("\nset title '{}'\nset xlabel '{}'\nplot {}\n", panel.title, panel.xLabel,
                        curves(comparison, 0, panel.x, panel.y, "linespoints lw 1.5 pt 7 ps 0.5")));
    }
    return figureOf(kErrorStyle, panels, kErrorColumns, data.take());
}

Plot spectrumFigure(const Comparison& comparison) {
    PlotData data;
    std::vector<std::string> panels;
    const std::size_t generators = comparison.generators.size();
    for (std::size_t i = 0; i < comparison.generators.front().images.size(); ++i) {
        for (std::size_t g = 0; g < generators; ++g) {
            data.begin("curve", i * generators + g);
            for (const RingPower& ring : comparison.generators[g].images[i].spectrum) {
                data.line("{:.9g} {:.9g}", ring.frequency, ring.power);
            }
        }
        const uint32_t samples = comparison.generators.front().images[i].samples;
        panels.push_back(fmt::format("\nset title '{} {}'\nplot 1 lc rgb 0x999999 notitle, {}\n",
                                     samples, samples == 1 ? "sample" : "samples",
                                     curves(comparison, i * generators, 1, 2, "lines lw 1.5")));
    }
    return figureOf(kSpectrumStyle, panels, kSpectrumColumns, data.take());
}

} // namespace wellstrat::cli
