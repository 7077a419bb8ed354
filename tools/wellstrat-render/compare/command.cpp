// SPDX-License-Identifier: Apache-2.0
//
// wellstrat compare: generators by the error of the images they make.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/command_line/render_commands.h"
#include "common/command_line/shell_word.h"
#include "common/output/page_plots.h"
#include "common/ranks/run_on_ranks.h"
#include "figures.h"
#include "image/files.h"
#include "image/run.h"
#include "page.h"
#include "run.h"
#include "scene/load.h"
#include "table.h"

#include "renderer/scene_fingerprint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Renders the scene with each generator, and reports the error against a reference at the numbers of
samples in --spp: RMSE, relative MSE, RMSE after the Gaussians of --filter, time, and how many
random samples would do the same; then the errors relative to those of random samples. The page has
pictures as they are and filtered, and spectra: whether the noise is white, or blue and so easy to
filter. The reference is rendered with other seeds, so that its noise is independent; one from
`wellstrat render` can be used again and again. With --seeds N there is none: every image is
rendered with N seeds, and as the samples are right on average, the spread of the N is the error.

With --mask only some pixels count, the same for all generators. `smooth` are those around which, in
5x5 pixels of the reference, (max - min) / (max + min + 0.02) is at most 0.1 in each color: at
silhouettes few pixels decide about the error. With --seeds the reference serves for that alone. Of
a picture FILE it is the pixels that are not black.

Examples:
  wellstrat compare cornell -o cornell.html
  wellstrat compare veach --spp 1,4,16,64 --reference-spp 1024 --size 128x96 -o veach.html
  wellstrat compare lens --generators pmj,joint --seeds 8 --size 96x64 -o lens.html
  wellstrat compare lens --spp 1,2,3,4,8,16 --filter 1,2 --mask smooth -o lens.html
  wellstrat render lens --seed 1 --spp 16384 -o lens.exr
  wellstrat compare lens --reference lens.exr --generators pmj,random -o lens.html

Exit codes: 0 done, 2 error, 130 interrupted.
)";

constexpr RealRange kSigmas{0.1, 100}; ///< in pixels
constexpr uint64_t kMostSeeds = 255; ///< with kMostMeasuredSamples, less than 2^32 samples in a sum

render::FilmPart readReference(const CompareOptions& options, const std::string& fingerprint,
                               ImageSize size) {
    const std::string& path = *options.reference;
    declareInput(path);
    render::FilmPart part = readImage(path);
    const auto refuse = [&path](const std::string& reason) {
        return CliError(fmt::format("--reference: '{}' {}", path, reason));
    };
    const auto wanted = imageSettings(options.scene, fingerprint, "");
    for (const char* name : {"scene", "depth"}) {
        if (part.settings[name] != wanted.at(name))
            throw refuse(fmt::format("differs in: {}", name));
    }
    if (part.film.width() != size.width || part.film.height() != size.height) {
        throw refuse(fmt::format("has {}x{} pixels, not {}x{}", part.film.width(),
                                 part.film.height(), size.width, size.height));
    }
    if (part.settings["seed"] == wanted.at("seed")) {
        throw refuse(
            "has the seed of what is compared, so its noise is not independent; render "
            "it with another --seed");
    }
    return part;
}

/// Throws CliError if the images that are kept until the end do not fit into memory.
void checkMemory(const CompareOptions& options, ImageSize size) {
    const uint64_t images = options.seeds.value_or(1) * options.spp.size();
    const uint64_t pixels = uint64_t{size.width} * size.height;
    requireMemory(options.seeds ? "--seeds" : "--spp", images * pixels * sizeof(render::PixelSums),
                  fmt::format("{} images of {}x{} pixels", images, size.width, size.height));
}

/// The pixels of a file that count.
render::PixelMask readMask(const std::string& path, ImageSize size) {
    const auto refuse = [&path](const std::string& reason) {
        return CliError(fmt::format("--mask: '{}' {}", path, reason));
    };
    declareInput(path);
    try {
        render::PixelMask mask = render::readMask(path);
        if (mask.width != size.width || mask.height != size.height) {
            throw refuse(fmt::format("has {}x{} pixels, not {}x{}", mask.width, mask.height,
                                     size.width, size.height));
        }
        if (countOf(mask) == 0) throw refuse("is black: no pixel would count");
        return mask;
    } catch (const CliError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw refuse(fmt::format("is neither '{}' nor a picture that can be read: {}", kSmoothMask,
                                 error.what()));
    }
}

CompareJob prepare(const CompareOptions& options, bool root) {
    for (const std::string& name : options.generators) renderGenerator(name);
    checkSamples(options.scene, "--spp", options.spp.back());
    const bool isSmooth = options.mask == kSmoothMask;
    if (options.seeds && !isSmooth && (options.reference || options.referenceSpp)) {
        throw CliError(
            "--seeds: errors need no reference, so --reference and --reference-spp go with "
            "it for --mask smooth only");
    }
    if (!options.seeds || isSmooth) {
        checkSamples(options.scene, "--reference-spp", referenceSamples(options));
    }
    requireSuffix("--output", options.output, {".html"});
    CompareJob job;
    if (root) job.file = std::make_unique<OutputFile>(options.output);
    job.scene = std::make_unique<render::Scene>(loadScene(options.scene));
    if (root) sayNotes(*job.scene);
    job.size = imageSize(options.scene, *job.scene);
    checkMemory(options, job.size);
    if (options.mask && !isSmooth) job.mask = readMask(*options.mask, job.size);
    if (options.reference) {
        job.reference = readReference(options, render::sceneFingerprint(*job.scene), job.size);
    }
    job.threads = limitThreads(options.scene);
    return job;
}

std::string referenceArguments(const CompareOptions& options) {
    std::string arguments;
    if (options.seeds) {
        arguments = fmt::format("--seeds {}", *options.seeds);
        if (options.mask != kSmoothMask) return arguments;
        arguments += ' ';
    }
    if (options.reference) return arguments + "--reference " + shellWord(*options.reference);
    return arguments + fmt::format("--reference-spp {}", referenceSamples(options));
}

std::string commandOf(const CompareOptions& options, ImageSize size) {
    return fmt::format(
        "wellstrat compare {} --generators {} --spp {} {} --filter {}{} -o {}",
        sceneArguments(options.scene, size), fmt::join(options.generators, ","),
        fmt::join(options.spp, ","), referenceArguments(options), fmt::join(options.filters, ","),
        options.mask ? " --mask " + shellWord(*options.mask) : "", shellWord(options.output));
}

std::vector<HtmlPicture> drawAll(const std::vector<CompareFigure>& figures, PagePlots& plots) {
    std::vector<HtmlPicture> pictures;
    for (const CompareFigure& figure : figures) {
        pictures.push_back({figure.description, plots.draw(figure.name, figure.plot)});
    }
    return pictures;
}

int run(const CompareOptions& options, const Ranks& ranks, CompareJob& job) {
    Comparison comparison(oneLine(options.scene.scene), job.size.width, job.size.height);
    if (!renderComparison(options, job, ranks, comparison)) {
        if (ranks.isRoot()) say("interrupted");
        return kExitInterrupted;
    }
    if (!ranks.isRoot()) return 0;
    PagePlots plots(options.output, options.keepPlotFiles);
    ComparePictures pictures;
    if (hasErrors(comparison)) {
        pictures = {drawAll(errorFigures(comparison), plots),
                    drawAll(spectrumFigures(comparison), plots)};
    }
    job.file->write(comparePage(comparison, pictures, commandOf(options, job.size)));
    job.file->commit();
    plots.commit();
    printText(compareTable(comparison));
    return 0;
}

/// Adds an option that takes a list of numbers, which are sorted. `read` makes a number of a text,
/// or returns false.
template <typename Number, typename Read>
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<Number>& numbers,
                     const std::string& accepted, const Read& read) {
    const auto readAll = [&numbers, name, accepted, read](const std::vector<std::string>& texts) {
        numbers.clear();
        for (const std::string& text : texts) {
            Number number{};
            if (!read(text, number)) {
                throw CLI::ValidationError(name, fmt::format("not {}: '{}'", accepted, text));
            }
            numbers.push_back(number);
        }
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    };
    return command.add_option_function<std::vector<std::string>>(name, readAll)
        ->delimiter(',')
        ->allow_extra_args(false);
}

void addCounts(CLI::App& command, std::vector<uint32_t>& counts) {
    addList(command, "--spp", counts,
            fmt::format("a whole number from 1 to {}", kMostMeasuredSamples),
            [](const std::string& text, uint32_t& count) {
                uint64_t number = 0;
                const bool isRead = parseNumber(text, {1, kMostMeasuredSamples}, number);
                count = static_cast<uint32_t>(number);
                return isRead;
            })
        ->description("Numbers of samples of each pixel [1,4,16,64,256,1024]")
        ->type_name("N,N");
}

void addFilters(CLI::App& command, std::vector<double>& filters) {
    addList(command, "--filter", filters,
            fmt::format("a number from {} to {}", kSigmas.min, kSigmas.max),
            [](const std::string& text, double& sigma) { return parseReal(text, kSigmas, sigma); })
        ->description("Errors after Gaussians of these standard deviations, in pixels [2]")
        ->type_name("SIGMA,SIGMA");
}

} // namespace

void addCompare(CLI::App& app, int& exitCode) {
    CLI::App* const command = app.add_subcommand(kCompare.name, kCompare.description);
    const auto options = std::make_shared<CompareOptions>();
    addSceneOptions(*command, options->scene)->required();
    addRenderGenerators(*command, options->generators,
                        "What is compared: pmj, joint, long, blue, random [pmj,random]");
    addCounts(*command, options->spp);
    addFilters(*command, options->filters);
    command
        ->add_option("--mask", options->mask,
                     "Which pixels count: smooth, or those of a picture that are not black [all]")
        ->type_name("smooth|FILE");
    CLI::Option* const reference =
        command
            ->add_option("--reference", options->reference,
                         "An image of `wellstrat render` with another --seed")
            ->type_name("FILE.exr");
    addNumber(*command, "--reference-spp", options->referenceSpp, {1, kMaxWord},
              "Samples of the reference [8 times the most of --spp]")
        ->excludes(reference);
    addNumber(*command, "--seeds", options->seeds, {2, kMostSeeds},
              "No reference: errors from the spread of images of N seeds, from --seed on");
    command->add_option("-o,--output", options->output, "The page: FILE.html")
        ->required()
        ->type_name("FILE");
    command->add_flag("--keep-plot-files", options->keepPlotFiles,
                      "Keep the plots: FILE-rmse and others, .svg, .dat and .gp");
    command->footer(kExamples);
    command->callback([options, &exitCode] {
        options->generators = eachOnce(options->generators);
        exitCode = runOnRanks(
            [&](const Ranks& ranks) { return prepare(*options, ranks.isRoot()); },
            [&](const Ranks& ranks, CompareJob& job) { return run(*options, ranks, job); });
    });
}

} // namespace wellstrat::cli
