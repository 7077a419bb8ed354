// SPDX-License-Identifier: Apache-2.0

#include "page.h"

#include "common/command_line/versions.h"
#include "common/output/html_page.h"
#include "common/output/readable_names.h"
#include "verdict.h"

#include "renderer/builtin_scenes.h"
#include "renderer/picture_file.h"
#include "renderer/pixel_mask.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

/// What is built in by what it is, a file by its name without folder and suffix.
std::string sceneTitle(const std::string& scene) {
    for (const render::BuiltinSceneInfo& info : render::builtinScenes()) {
        if (scene == info.name) return info.description;
    }
    return std::filesystem::path(scene).stem().string();
}

std::string pngOf(const render::Film& film) { return render::encodePicture(film, ".png"); }

render::Film pictureOf(const render::PixelMask& mask) {
    render::Film picture(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.counts.size(); ++i) {
        picture.add(static_cast<unsigned>(i % mask.width), static_cast<unsigned>(i / mask.width),
                    Float3(mask.counts[i] ? 1.0f : 0.0f));
    }
    return picture;
}

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
    std::string origin = reference.origin;
    origin[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(origin[0])));
    page.paragraph(fmt::format("{}. {}", origin, referenceError(comparison)));
    HtmlFigure figure{{{"The reference", pngOf(reference.film), "Reference"}},
                      fmt::format("The reference, {}x{} pixels, in sRGB.", reference.film.width(),
                                  reference.film.height()),
                      2};
    if (isMasked(comparison)) {
        const render::PixelMask& mask = comparison.measure.mask;
        figure.pictures.push_back(
            {"The pixels that count", pngOf(pictureOf(mask)), "White counts"});
        figure.caption += fmt::format(
            " White beside it: the {:.1f} % of the pixels whose errors "
            "count, {}.",
            percentOf(mask), comparison.maskOrigin);
    }
    page.figure(figure);
}

std::string explanation(const Comparison& comparison) {
    return fmt::format(
        "Over all {} and their three linear colors. The relative MSE is the mean of d\u00b2 / "
        "(r\u00b2 + 0.01) with d the difference from the reference r. A filtered RMSE is taken "
        "after "
        "a Gaussian, whose standard deviation is given in pixels, has blurred d: noise of high "
        "frequency, which the eye and denoisers forgive, counts less. The Gaussian ends after "
        "three standard deviations, and what is outside of the image{} is not there for it: the "
        "other weights are scaled to sum 1. The last column before standard errors says how many "
        "samples of \u201c{}\u201d have "
        "the same RMSE: between its points on a line in logarithmic axes, beyond them by the "
        "law of independent samples, one over the root of their number.",
        isMasked(comparison) ? "pixels that count" : "pixels",
        isMasked(comparison) ? ", or does not count," : "",
        generatorTitle(baselineOf(comparison).name));
}

HtmlTable tableOfErrors(const Comparison& comparison) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    HtmlTable table{
        "All numbers; of each number of samples the least errors are marked. Times are of "
        "this machine, with all that ran on it.",
        {"generator", "samples", "RMSE", "relative MSE"},
        {}};
    const auto addFiltered = [&](const std::string& what) {
        for (const render::GaussianBlur& blur : comparison.measure.blurs) {
            table.header.push_back(what + " at " + filterName(blur.sigma()));
        }
    };
    addFiltered("RMSE");
    table.header.emplace_back("seconds");
    table.header.push_back("as samples of " + generatorTitle(baseline.name));
    if (hasUncertainties(comparison)) {
        table.header.emplace_back("\u00b1 RMSE");
        addFiltered("\u00b1");
        table.caption += " The last columns are standard errors.";
    }
    for (const ComparedGenerator& generator : comparison.generators) {
        for (const ComparedImage& image : generator.images) {
            std::vector<std::string> row{generatorTitle(generator.name),
                                         fmt::format("{}", image.samples)};
            const auto addNumbers = [&row](const char* format, const std::vector<double>& numbers) {
                for (const double number : numbers) {
                    row.push_back(fmt::format(fmt::runtime(format), number));
                }
            };
            addNumbers("{:#.3g}", {image.error.rmse, image.error.relativeMse});
            addNumbers("{:#.3g}", image.error.filtered);
            addNumbers("{:.2f}", {image.seconds});
            addNumbers("{:.1f}", {equivalentSamples(baseline, image.error.rmse)});
            if (image.uncertainty) {
                addNumbers("{:.1e}", {image.uncertainty->rmse});
                addNumbers("{:.1e}", image.uncertainty->filtered);
            }
            table.rows.push_back(std::move(row));
        }
    }
    const std::size_t counts = baseline.images.size(), generators = comparison.generators.size();
    const std::size_t errors = 2 + comparison.measure.blurs.size();
    for (std::size_t i = 0; i < counts; ++i) {
        std::vector<std::size_t> ofCount;
        for (std::size_t g = 0; g < generators; ++g) ofCount.push_back(g * counts + i);
        for (std::size_t c = 2; c < 2 + errors; ++c) table.markBest(c, ofCount, Best::least);
    }
    return table;
}

HtmlTable tableOfRatios(const Comparison& comparison) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    HtmlTable table{
        fmt::format("RMSE over that of \u201c{}\u201d with as many samples: less is better, the "
                    "least after each filter is marked.",
                    generatorTitle(baseline.name)),
        {"generator", "filter"},
        {}};
    for (const ComparedImage& image : baseline.images) {
        table.header.push_back(samplesText(image.samples));
    }
    for (const RelativeErrors& errors : relativeErrors(comparison)) {
        std::vector<std::string> row{generatorTitle(errors.generator), errors.filter};
        for (const double ratio : errors.ratios) row.push_back(ratioText(ratio));
        table.rows.push_back(std::move(row));
    }
    const std::size_t filters = 1 + comparison.measure.blurs.size();
    for (std::size_t filter = 0; filter < filters; ++filter) {
        std::vector<std::size_t> ofFilter;
        for (std::size_t r = filter; r < table.rows.size(); r += filters) ofFilter.push_back(r);
        for (std::size_t c = 2; c < table.header.size(); ++c) {
            table.markBest(c, ofFilter, Best::least);
        }
    }
    return table;
}

void addErrors(const Comparison& comparison, const std::vector<HtmlPicture>& curves,
               HtmlPage& page) {
    page.section("Errors");
    if (curves.empty()) {
        page.paragraph("All images equal the reference, so there are no error curves to draw.");
    } else {
        page.figure({curves,
                     "Error against the number of samples and against time, in logarithmic axes.",
                     2});
    }
    if (comparison.generators.size() > 1) page.table(tableOfRatios(comparison));
    page.table(tableOfErrors(comparison));
    page.paragraph(explanation(comparison));
}

void addSpectra(const std::vector<HtmlPicture>& spectra, HtmlPage& page) {
    page.section("Spectra");
    page.paragraph(
        "How the power of the errors is spread over frequencies, as means over rings of "
        "them, in units of the mean of all. White noise is 1 at each. What is below 1 at "
        "low frequencies, to the left, looks better and is easier to filter.");
    page.figure({spectra, "The radial power spectrum of the errors, by samples of each pixel.", 3});
}

/// One picture of each generator, and the reference.
HtmlFigure rowOfCrops(const Comparison& comparison, std::size_t image, const std::string& after,
                      const render::Film& reference,
                      const std::function<const render::Film&(const ComparedImage&)>& crop) {
    const std::string samples =
        samplesText(comparison.generators.front().images[image].samples) + " of each pixel";
    HtmlFigure figure;
    for (const ComparedGenerator& generator : comparison.generators) {
        const std::string title = generatorTitle(generator.name);
        figure.pictures.push_back({fmt::format("{}, {}{}", title, samples, after),
                                   pngOf(crop(generator.images[image])), title});
    }
    figure.pictures.push_back(
        {"The same part of the reference" + after, pngOf(reference), "Reference"});
    figure.columns = figure.pictures.size() > 2 ? 4 : 2;
    figure.caption = fmt::format("{}{}.", samples, after);
    return figure;
}

void addCrops(const Comparison& comparison, HtmlPage& page) {
    const Crop& crop = comparison.crop;
    const render::Film reference = enlarged(comparison.reference.film, crop);
    page.section("Side by side");
    page.paragraph(
        fmt::format("Pixels {} to {} across and {} to {} down, where the first image "
                    "differs most, each drawn as a square, as they are and after the filters.",
                    crop.x, crop.x + crop.width - 1, crop.y, crop.y + crop.height - 1));
    for (std::size_t i = 0; i < comparison.generators.front().images.size(); ++i) {
        page.figure(rowOfCrops(
            comparison, i, "", reference,
            [](const ComparedImage& image) -> const render::Film& { return image.crop; }));
        for (std::size_t k = 0; k < comparison.blurredReference.size(); ++k) {
            page.figure(rowOfCrops(
                comparison, i, ", filtered at " + filterName(comparison.measure.blurs[k].sigma()),
                comparison.blurredReference[k],
                [k](const ComparedImage& image) -> const render::Film& {
                    return image.blurredCrops[k];
                }));
        }
    }
}

} // namespace

std::string comparePage(const Comparison& comparison, const ComparePictures& pictures,
                        const std::string& command) {
    std::vector<std::string> titles;
    for (const ComparedGenerator& generator : comparison.generators) {
        titles.push_back(generatorTitle(generator.name));
    }
    HtmlPage page("Samples compared in pictures", verdictOf(comparison),
                  fmt::format("Images of {}, by what their samples are: {}.",
                              sceneTitle(comparison.scene), fmt::join(titles, "; ")));
    addCrops(comparison, page);
    addErrors(comparison, pictures.errors, page);
    if (!pictures.spectra.empty()) addSpectra(pictures.spectra, page);
    addReference(comparison, page);
    page.section("How to make this again");
    page.code(command);
    page.paragraph(versionLine() + ".");
    return page.finish();
}

} // namespace wellstrat::cli
