// SPDX-License-Identifier: Apache-2.0

#include "common/command_line/versions.h"
#include "common/output/curve_style.h"
#include "common/output/plot_data.h"
#include "result.h"

#include "renderer/film_file.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kStyle = R"(set logscale xy
set format x '%g'
set format y '10^{%T}'
set grid lc rgb 0xdddddd lt 1
set key top right samplen 2 spacing 1 noenhanced
)";

struct Panel {
    const char* title;
    const char* xLabel;
    unsigned x, y; ///< columns of the data
};

constexpr Panel kPanels[]{{"RMSE", "samples of a pixel", 1, 2},
                          {"RMSE after a Gaussian blur", "samples of a pixel", 1, 4},
                          {"relative MSE", "samples of a pixel", 1, 3},
                          {"RMSE against time", "seconds", 5, 2}};

std::string panelScript(const Panel& panel, const Comparison& comparison) {
    std::string curves;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        curves += fmt::format(
            "{}data index 'curve{}' using {}:{} with linespoints lw 1.5 pt 7 ps 0.5 {} "
            "title '{}'",
            i == 0 ? "" : ", \\\n     ", i, panel.x, panel.y, curveStyle(i),
            plainName(comparison.generators[i].name));
    }
    return fmt::format("\nset title '{}'\nset xlabel '{}'\nplot {}\n", panel.title, panel.xLabel,
                       curves);
}

std::string samplesText(uint32_t samples) {
    return fmt::format("{} {}", samples, samples == 1 ? "sample" : "samples");
}

std::string pngOf(const render::Film& film) { return render::encodePicture(film, ".png"); }

/// What is known of the error of the reference.
std::string referenceError(const Comparison& comparison) {
    if (hasUncertainties(comparison)) {
        return "Images of other seeds are independent and right on average, so how far they are "
               "from their mean tells how far each of them is from the truth.";
    }
    if (!comparison.reference.error) {
        return "Its own error is not known; measured errors contain it.";
    }
    return fmt::format(
        "Its own RMSE is about {:.1e}, half of that between its two halves; "
        "measured errors near it are too large.",
        *comparison.reference.error);
}

void addReference(const Comparison& comparison, HtmlPage& page) {
    const Reference& reference = comparison.reference;
    page.section("Reference");
    page.paragraph(fmt::format("{}. {}", reference.origin, referenceError(comparison)));
    page.figure({{{"The reference", pngOf(reference.film)}},
                 fmt::format("The reference, {}x{} pixels, in sRGB.", reference.film.width(),
                             reference.film.height())});
}

void addErrors(const Comparison& comparison, const std::string& figure, HtmlPage& page) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    page.section("Errors");
    page.paragraph(fmt::format(
        "Over all pixels and their three linear colors. The relative MSE is the mean of d^2 / "
        "(r^2 + 0.01) with d the difference from the reference r. The filtered RMSE is taken after "
        "a Gaussian of standard deviation {} pixels has blurred d: noise of high frequency, which "
        "the eye and denoisers forgive, counts less. The last column says how many samples of {} "
        "have the same RMSE: between its points on a line in logarithmic axes, beyond them by RMSE "
        "~ N^(-1/2).",
        render::kErrorBlur, baseline.name));
    if (figure.empty()) {
        page.paragraph("All images equal the reference, so there are no error curves to draw.");
    } else {
        page.figure({{{"Error curves of the generators", figure}},
                     "Error against the number of samples and against time, in logarithmic axes."});
    }
    HtmlTable table{"All numbers. Times are of this machine, with all that ran on it.",
                    {"generator", "samples", "RMSE", "relative MSE", "filtered RMSE", "seconds",
                     fmt::format("samples of {}", baseline.name)},
                    {}};
    for (const ComparedGenerator& generator : comparison.generators) {
        for (const ComparedImage& image : generator.images) {
            table.rows.push_back(
                {generator.name, fmt::format("{}", image.samples),
                 fmt::format("{:.4e}", image.error.rmse),
                 fmt::format("{:.4e}", image.error.relativeMse),
                 fmt::format("{:.4e}", image.error.filtered), fmt::format("{:.2f}", image.seconds),
                 fmt::format("{:.1f}", equivalentSamples(baseline, image.error.rmse))});
            if (!image.uncertainty) continue;
            table.rows.back().push_back(fmt::format("{:.1e}", image.uncertainty->rmse));
            table.rows.back().push_back(fmt::format("{:.1e}", image.uncertainty->filtered));
        }
    }
    if (hasUncertainties(comparison)) {
        table.header.emplace_back("+- RMSE");
        table.header.emplace_back("+- filtered");
        table.caption += " The last columns are standard errors.";
    }
    page.table(table);
}

void addCrops(const Comparison& comparison, HtmlPage& page) {
    const Crop& crop = comparison.crop;
    const std::string reference = pngOf(enlarged(comparison.reference.film, crop));
    page.section("Side by side");
    page.paragraph(
        fmt::format("Pixels {} to {} across and {} to {} down, where the first image "
                    "differs most, each drawn as a square.",
                    crop.x, crop.x + crop.width - 1, crop.y, crop.y + crop.height - 1));
    for (std::size_t i = 0; i < comparison.generators.front().images.size(); ++i) {
        HtmlFigure figure;
        std::string names;
        for (const ComparedGenerator& generator : comparison.generators) {
            const ComparedImage& image = generator.images[i];
            figure.pictures.push_back(
                {fmt::format("{}, {} of each pixel", generator.name, samplesText(image.samples)),
                 pngOf(image.crop)});
            names += generator.name + ", ";
        }
        figure.pictures.push_back({"The same part of the reference", reference});
        figure.caption =
            fmt::format("{} of each pixel: {}and the reference.",
                        samplesText(comparison.generators.front().images[i].samples), names);
        page.figure(figure);
    }
}

} // namespace

Plot compareFigure(const Comparison& comparison) {
    PlotData data;
    for (std::size_t i = 0; i < comparison.generators.size(); ++i) {
        data.begin("curve", i);
        for (const ComparedImage& image : comparison.generators[i].images) {
            data.line("{} {:.9g} {:.9g} {:.9g} {:.9g}", image.samples, image.error.rmse,
                      image.error.relativeMse, image.error.filtered, image.seconds);
        }
    }
    std::string script = kStyle;
    script += "set multiplot layout 2,2\n";
    for (const Panel& panel : kPanels) script += panelScript(panel, comparison);
    script += "\nunset multiplot\n";
    return {script, data.take(), 960, 760};
}

std::string comparePage(const Comparison& comparison, const std::string& figure,
                        const std::string& command) {
    std::string names;
    for (const ComparedGenerator& generator : comparison.generators) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", generator.name);
    }
    HtmlPage page(fmt::format("{}: generators compared", comparison.scene),
                  fmt::format("How far images of the scene are from a reference, by the generator "
                              "of their samples: {}.",
                              names));
    addReference(comparison, page);
    addErrors(comparison, figure, page);
    addCrops(comparison, page);
    page.section("How to make this again");
    page.code(command);
    page.paragraph(versionLine() + ".");
    return page.finish();
}

} // namespace wellstrat::cli
