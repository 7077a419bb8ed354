// SPDX-License-Identifier: Apache-2.0

#include "figures.h"

#include "common/output/axes.h"
#include "common/output/curve_style.h"
#include "common/output/plot_data.h"
#include "common/output/readable_names.h"

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kGrid = "set grid lc rgb 0xdddddd lt 1\n";

constexpr auto kSpectrumStyle = R"(set xrange [0:0.5]
set yrange [0:2<*]
set xlabel 'cycles a pixel'
)";

constexpr unsigned kWidth = 480, kHeight = 340, kLegendLine = 20;

/// A number of an image.
using ImageNumber = std::function<double(const ComparedImage&)>;

/// The curves of all generators, which are the sets 0, 1, ... of the data.
std::string curves(const Comparison& comparison, const char* points) {
    std::string text;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        text += fmt::format("{}data index 'curve{}' using 1:2 with {} {} title '{}'",
                            i == 0 ? "" : ", \\\n     ", i, points, curveStyle(i),
                            plainName(generatorTitle(comparison.generators[i].name)));
    }
    return text + "\n";
}

unsigned heightOf(const Comparison& comparison) {
    return kHeight + kLegendLine * static_cast<unsigned>(comparison.generators.size());
}

struct ErrorPanel {
    std::string title;
    bool overTime; ///< else over samples
    ImageNumber error;
};

Plot errorPlot(const Comparison& comparison, const ErrorPanel& panel) {
    PlotData data;
    AxisRange x, y;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        data.begin("curve", i);
        for (const ComparedImage& image : comparison.generators[i].images) {
            const double place = panel.overTime ? image.seconds : image.samples;
            const double error = panel.error(image);
            if (!(place > 0 && error > 0)) continue; // there is no place for it
            data.line("{:.9g} {:.9g}", place, error);
            x.add(place);
            y.add(error);
        }
    }
    return {fmt::format("{}{}set title '{}'\nset xlabel '{}'\n{}{}plot {}", kGrid, kLegendBelow,
                        panel.title, panel.overTime ? "seconds" : "samples of a pixel",
                        panel.overTime ? decimalAxis("x", x) : doublingAxis("x", x),
                        decimalAxis("y", y), curves(comparison, "linespoints lw 1.5 pt 7 ps 0.5")),
            data.take(), kWidth, heightOf(comparison)};
}

Plot spectrumPlot(const Comparison& comparison, std::size_t image, const std::string& title) {
    PlotData data;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        data.begin("curve", i);
        for (const RingPower& ring : comparison.generators[i].images[image].spectrum) {
            data.line("{:.9g} {:.9g}", ring.frequency, ring.power);
        }
    }
    return {fmt::format("{}{}{}set title '{}'\nplot 1 lc rgb 0x999999 notitle, {}", kGrid,
                        kLegendBelow, kSpectrumStyle, title, curves(comparison, "lines lw 1.5")),
            data.take(), kWidth, heightOf(comparison)};
}

} // namespace

std::vector<CompareFigure> errorFigures(const Comparison& comparison) {
    const auto rmse = [](const ComparedImage& image) { return image.error.rmse; };
    std::vector<CompareFigure> figures;
    const auto add = [&](const std::string& name, const ErrorPanel& panel) {
        figures.push_back({name, panel.title, errorPlot(comparison, panel)});
    };
    add("rmse", {"RMSE", false, rmse});
    for (std::size_t k = 0; k < comparison.measure.blurs.size(); ++k) {
        const std::string filter = filterName(comparison.measure.blurs[k].sigma());
        add("rmse-" + filter,
            {"RMSE after a Gaussian of " + filter, false,
             [k](const ComparedImage& image) { return image.error.filtered[k]; }});
    }
    add("relative-mse", {"relative MSE", false,
                         [](const ComparedImage& image) { return image.error.relativeMse; }});
    add("time", {"RMSE against time", true, rmse});
    return figures;
}

std::vector<CompareFigure> spectrumFigures(const Comparison& comparison) {
    std::vector<CompareFigure> figures;
    const std::vector<ComparedImage>& images = comparison.generators.front().images;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::string samples = samplesText(images[i].samples);
        figures.push_back({fmt::format("spectrum-{}", images[i].samples),
                           "Spectra of the errors, " + samples,
                           spectrumPlot(comparison, i, samples)});
    }
    return figures;
}

} // namespace wellstrat::cli
