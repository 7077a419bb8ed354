// SPDX-License-Identifier: Apache-2.0

#include "page.h"

#include "common/command_line/versions.h"
#include "common/output/html_page.h"

#include "renderer/picture_file.h"
#include "renderer/pixel_mask.h"

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

std::string samplesText(uint32_t samples) {
    return fmt::format("{} {}", samples, samples == 1 ? "sample" : "samples");
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
    page.paragraph(fmt::format("{}. {}", reference.origin, referenceError(comparison)));
    HtmlFigure figure{{{"The reference", pngOf(reference.film)}},
                      fmt::format("The reference, {}x{} pixels, in sRGB.", reference.film.width(),
                                  reference.film.height())};
    if (isMasked(comparison)) {
        const render::PixelMask& mask = comparison.measure.mask;
        figure.pictures.push_back({"The pixels that count", pngOf(pictureOf(mask))});
        figure.caption += fmt::format(
            " White beside it: the {:.1f} % of the pixels whose errors "
            "count, {}.",
            percentOf(mask), comparison.maskOrigin);
    }
    page.figure(figure);
}

std::string explanation(const Comparison& comparison) {
    return fmt::format(
        "Over all {} and their three linear colors. The relative MSE is the mean of d^2 / "
        "(r^2 + 0.01) with d the difference from the reference r. A filtered RMSE is taken after "
        "a Gaussian, whose standard deviation is given in pixels, has blurred d: noise of high "
        "frequency, which the eye and denoisers forgive, counts less. The Gaussian ends after "
        "three standard deviations, and what is outside of the image{} is not there for it: the "
        "other weights are scaled to sum 1. The column of samples of {} says how many of them have "
        "the same RMSE: between its points on a line in logarithmic axes, beyond them by RMSE ~ "
        "N^(-1/2).",
        isMasked(comparison) ? "pixels that count" : "pixels",
        isMasked(comparison) ? ", or does not count," : "", baselineOf(comparison).name);
}

HtmlTable tableOfErrors(const Comparison& comparison) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    HtmlTable table{"All numbers. Times are of this machine, with all that ran on it.",
                    {"generator", "samples", "RMSE", "relative MSE"},
                    {}};
    const auto addFiltered = [&](const std::string& what) {
        for (const render::GaussianBlur& blur : comparison.measure.blurs) {
            table.header.push_back(what + " at " + filterName(blur.sigma()));
        }
    };
    addFiltered("RMSE");
    table.header.emplace_back("seconds");
    table.header.push_back("samples of " + baseline.name);
    if (hasUncertainties(comparison)) {
        table.header.emplace_back("+- RMSE");
        addFiltered("+-");
        table.caption += " The last columns are standard errors.";
    }
    for (const ComparedGenerator& generator : comparison.generators) {
        for (const ComparedImage& image : generator.images) {
            std::vector<std::string> row{generator.name, fmt::format("{}", image.samples)};
            const auto addNumbers = [&row](const char* format, const std::vector<double>& numbers) {
                for (const double number : numbers) {
                    row.push_back(fmt::format(fmt::runtime(format), number));
                }
            };
            addNumbers("{:.4e}", {image.error.rmse, image.error.relativeMse});
            addNumbers("{:.4e}", image.error.filtered);
            addNumbers("{:.2f}", {image.seconds});
            addNumbers("{:.1f}", {equivalentSamples(baseline, image.error.rmse)});
            if (image.uncertainty) {
                addNumbers("{:.1e}", {image.uncertainty->rmse});
                addNumbers("{:.1e}", image.uncertainty->filtered);
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

HtmlTable tableOfRatios(const Comparison& comparison) {
    const ComparedGenerator& baseline = baselineOf(comparison);
    HtmlTable table{fmt::format("RMSE relative to that of {} with as many samples: less is better.",
                                baseline.name),
                    {"generator", "filter"},
                    {}};
    for (const ComparedImage& image : baseline.images) {
        table.header.push_back(samplesText(image.samples));
    }
    for (const RelativeErrors& errors : relativeErrors(comparison)) {
        std::vector<std::string> row{errors.generator, errors.filter};
        for (const double ratio : errors.ratios) row.push_back(ratioText(ratio));
        table.rows.push_back(std::move(row));
    }
    return table;
}

void addErrors(const Comparison& comparison, const std::string& figure, HtmlPage& page) {
    page.section("Errors");
    page.paragraph(explanation(comparison));
    if (figure.empty()) {
        page.paragraph("All images equal the reference, so there are no error curves to draw.");
    } else {
        page.figure({{{"Error curves of the generators", figure}},
                     "Error against the number of samples and against time, in logarithmic axes."});
    }
    if (comparison.generators.size() > 1) page.table(tableOfRatios(comparison));
    page.table(tableOfErrors(comparison));
}

void addSpectra(const std::string& figure, HtmlPage& page) {
    page.section("Spectra");
    page.paragraph(
        "How the power of the errors is spread over frequencies, as means over rings of "
        "them, in units of the mean of all. White noise is 1 at each. What is below 1 at "
        "low frequencies, to the left, looks better and is easier to filter.");
    page.figure({{{"Spectra of the errors", figure}},
                 "The radial power spectrum of the errors, by samples of each pixel."});
}

/// One picture of each generator, and the reference.
HtmlFigure rowOfCrops(const Comparison& comparison, std::size_t image, const std::string& after,
                      const render::Film& reference,
                      const std::function<const render::Film&(const ComparedImage&)>& crop) {
    const std::string samples =
        samplesText(comparison.generators.front().images[image].samples) + " of each pixel";
    HtmlFigure figure;
    std::string names;
    for (const ComparedGenerator& generator : comparison.generators) {
        figure.pictures.push_back({fmt::format("{}, {}{}", generator.name, samples, after),
                                   pngOf(crop(generator.images[image]))});
        names += generator.name + ", ";
    }
    figure.pictures.push_back({"The same part of the reference" + after, pngOf(reference)});
    if (figure.pictures.size() > 3) figure.columns = 4;
    figure.caption = fmt::format("{}{}: {}and the reference.", samples, after, names);
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

std::string comparePage(const Comparison& comparison, const CompareFigures& figures,
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
    addErrors(comparison, figures.errors, page);
    if (!figures.spectra.empty()) addSpectra(figures.spectra, page);
    addCrops(comparison, page);
    page.section("How to make this again");
    page.code(command);
    page.paragraph(versionLine() + ".");
    return page.finish();
}

} // namespace wellstrat::cli
