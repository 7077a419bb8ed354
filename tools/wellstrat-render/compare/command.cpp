// SPDX-License-Identifier: Apache-2.0
//
// wellstrat compare: generators by the error of the images they make.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/options.h"
#include "common/command_line/render_commands.h"
#include "common/ranks/run_on_ranks.h"
#include "image/files.h"
#include "image/run.h"
#include "run.h"
#include "scene/load.h"

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
samples in --spp: RMSE, relative MSE, RMSE after a Gaussian blur, time, and how many random samples
would do the same. The reference is rendered with other seeds, so that its noise is independent; one
from `wellstrat render` can be used again and again. With --seeds N there is none: every image is
rendered with N seeds, and as the samples are right on average, the spread of the N is the error.

Examples:
  wellstrat compare cornell -o cornell.html
  wellstrat compare veach --spp 1,4,16,64 --reference-spp 1024 --size 128x96 -o veach.html
  wellstrat compare lens --generators pmj,joint --seeds 8 --size 96x64 -o lens.html
  wellstrat render lens --seed 1 --spp 16384 -o lens.exr
  wellstrat compare lens --reference lens.exr --generators pmj,random -o lens.html

Exit codes: 0 done, 2 error, 130 interrupted.
)";

constexpr uint64_t kMostSeeds = 255; ///< with kMostMeasuredSamples, less than 2^32 samples in a sum

render::FilmPart readReference(const CompareOptions& options, const std::string& fingerprint,
                               ImageSize size) {
    const std::string& path = *options.reference;
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

CompareJob prepare(const CompareOptions& options, bool root) {
    for (const std::string& name : options.generators) renderGenerator(name);
    checkSamples(options.scene, "--spp", options.spp.back());
    if (!options.seeds) checkSamples(options.scene, "--reference-spp", referenceSamples(options));
    requireSuffix("--output", options.output, {".html"});
    CompareJob job;
    if (root) {
        job.file = std::make_unique<OutputFile>(options.output);
        if (options.keepPlotFiles) {
            const std::string stem = options.output.substr(0, options.output.rfind('.'));
            job.curves = std::make_unique<Picture>("--output", stem + "-errors.svg", true);
        }
    }
    job.scene = std::make_unique<render::Scene>(loadScene(options.scene));
    if (root) sayNotes(*job.scene);
    job.size = imageSize(options.scene, *job.scene);
    checkMemory(options, job.size);
    if (options.reference) {
        job.reference = readReference(options, render::sceneFingerprint(*job.scene), job.size);
    }
    job.threads = limitThreads(options.scene);
    return job;
}

std::string referenceArguments(const CompareOptions& options) {
    if (options.seeds) return fmt::format("--seeds {}", *options.seeds);
    if (options.reference) return "--reference " + shellWord(*options.reference);
    return fmt::format("--reference-spp {}", referenceSamples(options));
}

std::string commandOf(const CompareOptions& options, ImageSize size) {
    return fmt::format("wellstrat compare {} --generators {} --spp {} {} -o {}",
                       sceneArguments(options.scene, size), fmt::join(options.generators, ","),
                       fmt::join(options.spp, ","), referenceArguments(options),
                       shellWord(options.output));
}

int run(const CompareOptions& options, const Ranks& ranks, CompareJob& job) {
    Comparison comparison{oneLine(options.scene.scene),
                          {render::Film(job.size.width, job.size.height), "", {}},
                          {0, 0, 0, 0},
                          {}};
    if (!renderComparison(options, job, ranks, comparison)) {
        if (ranks.isRoot()) fmt::print(stderr, "wellstrat: interrupted\n");
        return kExitInterrupted;
    }
    if (!ranks.isRoot()) return 0;
    std::string figure;
    if (hasErrors(comparison)) {
        const Plot plot = compareFigure(comparison);
        figure = job.curves ? job.curves->draw(plot) : drawPlot(plot, ".svg").picture;
    } else {
        job.curves.reset();
    }
    job.file->write(comparePage(comparison, figure, commandOf(options, job.size)));
    job.file->commit();
    if (job.curves) job.curves->commit();
    printText(compareTable(comparison));
    return 0;
}

void addCounts(CLI::App& command, std::vector<uint32_t>& counts) {
    const auto read = [&counts](const std::vector<std::string>& texts) {
        counts.clear();
        for (const std::string& text : texts) {
            uint64_t count = 0;
            if (!parseNumber(text, {1, kMostMeasuredSamples}, count)) {
                throw CLI::ValidationError("--spp",
                                           fmt::format("not a whole number from 1 to {}: '{}'",
                                                       kMostMeasuredSamples, text));
            }
            counts.push_back(static_cast<uint32_t>(count));
        }
        std::sort(counts.begin(), counts.end());
        counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    };
    command
        .add_option_function<std::vector<std::string>>(
            "--spp", read, "Numbers of samples of each pixel [1,4,16,64,256,1024]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("N,N");
}

} // namespace

void addCompare(CLI::App& app, int& exitCode) {
    CLI::App* const command = app.add_subcommand(kCompare.name, kCompare.description);
    const auto options = std::make_shared<CompareOptions>();
    addSceneOptions(*command, options->scene)->required();
    addRenderGenerators(*command, options->generators,
                        "What is compared: pmj, joint, long, blue, random [pmj,random]");
    addCounts(*command, options->spp);
    CLI::Option* const reference =
        command
            ->add_option("--reference", options->reference,
                         "An image of `wellstrat render` with another --seed")
            ->type_name("FILE.exr");
    addNumber(*command, "--reference-spp", options->referenceSpp, {1, kMaxWord},
              "Samples of the reference [8 times the most of --spp]")
        ->excludes(reference);
    addNumber(*command, "--seeds", options->seeds, {2, kMostSeeds},
              "No reference: errors from the spread of images of N seeds, from --seed on")
        ->excludes(reference)
        ->excludes("--reference-spp");
    command->add_option("-o,--output", options->output, "The page: FILE.html")
        ->required()
        ->type_name("FILE");
    command->add_flag("--keep-plot-files", options->keepPlotFiles,
                      "Keep the error curves: FILE-errors.svg, .dat and .gp");
    command->footer(kExamples);
    command->callback([options, &exitCode] {
        exitCode = runOnRanks(
            [&](const Ranks& ranks) { return prepare(*options, ranks.isRoot()); },
            [&](const Ranks& ranks, CompareJob& job) { return run(*options, ranks, job); });
    });
}

} // namespace wellstrat::cli
