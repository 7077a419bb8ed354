// SPDX-License-Identifier: Apache-2.0
//
// wellstrat compare: generators by the error of the images they make.

#include "commands.h"
#include "compare_result.h"
#include "errors.h"
#include "image_files.h"
#include "interrupt.h"
#include "options.h"
#include "output_file.h"
#include "render_run.h"
#include "run_on_ranks.h"
#include "sampling.h"
#include "scene_options.h"

#include "renderer/scene_fingerprint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Renders the scene with each generator, and reports the error against a reference at the numbers of
samples in --spp: RMSE, relative MSE, RMSE after a Gaussian blur, time, and how many random samples
would do the same. The reference is rendered with other seeds, so that its noise is independent; one
from `wellstrat render` can be used again and again.

Examples:
  wellstrat compare cornell -o cornell.html
  wellstrat compare veach --spp 1,4,16,64 --reference-spp 1024 --size 128x96 -o veach.html
  wellstrat render lens --seed 1 --spp 16384 -o lens.exr
  wellstrat compare lens --reference lens.exr --generators pmj,random -o lens.html

Exit codes: 0 done, 2 error, 130 interrupted.
)";

constexpr uint64_t kMostSamples = 1 << 24;
constexpr uint64_t kReferenceFactor = 8;

struct CompareOptions {
    SceneOptions scene;
    std::vector<std::string> generators{"pmj", "random"};
    std::vector<uint32_t> spp{1, 4, 16, 64, 256, 1024};
    std::optional<std::string> reference;
    std::optional<uint64_t> referenceSpp;
    std::string output;
    bool keepPlotFiles = false;
};

/// All that is made before anything is rendered.
struct CompareJob {
    std::unique_ptr<tbb::global_control> threads;
    std::unique_ptr<render::Scene> scene;
    ImageSize size{};
    std::optional<render::FilmPart> reference; ///< of --reference
    std::unique_ptr<OutputFile> file;          ///< of rank 0
    std::unique_ptr<Picture> curves;           ///< if it is kept
};

uint64_t referenceSamples(const CompareOptions& options) {
    return options.referenceSpp.value_or(kReferenceFactor * options.spp.back());
}

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

CompareJob prepare(const CompareOptions& options, bool root) {
    for (const std::string& name : options.generators) findGenerator("--generators", name);
    checkSamples(options.scene, "--spp", options.spp.back());
    checkSamples(options.scene, "--reference-spp", referenceSamples(options));
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
    if (options.reference) {
        job.reference = readReference(options, render::sceneFingerprint(*job.scene), job.size);
    }
    job.threads = limitThreads(options.scene);
    return job;
}

/// Renders images of one generator.
class GeneratorRun {
public:
    GeneratorRun(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                 const std::string& name, uint64_t seed)
        : ranks_(ranks), name_(name), film_(job.size.width, job.size.height) {
        SceneOptions scene = options.scene;
        scene.seed = seed;
        renderer_ = makeRenderer(scene, *job.scene, job.size,
                                 findGenerator("--generators", name).generator);
    }

    /// Goes on to `samples` of each pixel. False if it was interrupted.
    bool render(uint32_t samples) {
        const auto start = std::chrono::steady_clock::now();
        const RenderPlan plan{0, samples, {}, {}, fmt::format("{}, {} samples", name_, samples)};
        const RenderEnd end = runRender(*renderer_, plan, ranks_, film_, {}, {});
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return end == RenderEnd::finished;
    }

    const render::Film& film() const { return film_; }
    double seconds() const { return seconds_; }

private:
    const Ranks& ranks_;
    std::string name_;
    render::Film film_;
    std::unique_ptr<render::Renderer> renderer_;
    double seconds_ = 0;
};

/// Renders a reference as two halves of other seeds, whose difference tells its error: halves A and
/// B are independent and equally wrong, so the RMSE of (A + B) / 2 is half that between A and B.
/// False if it was interrupted.
bool renderReference(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                     Reference& reference) {
    const auto samples = static_cast<uint32_t>((referenceSamples(options) + 1) / 2);
    const uint64_t seeds[2]{options.scene.seed ^ kMaxWord, options.scene.seed ^ (kMaxWord - 1)};
    std::optional<render::Film> first;
    for (const uint64_t seed : seeds) {
        GeneratorRun run(options, job, ranks, "pmj", seed);
        if (!run.render(samples)) return false;
        if (!first) {
            first = run.film();
            continue;
        }
        reference.error = render::filmError(*first, run.film()).rmse / 2;
        reference.film = std::move(*first);
        reference.film.add(run.film());
    }
    reference.origin = fmt::format("pmj, twice {} samples of each pixel, seeds {} and {}", samples,
                                   seeds[0], seeds[1]);
    return true;
}

/// Fills in the reference. False if it was interrupted.
bool findReference(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
                   Reference& reference) {
    if (!job.reference) return renderReference(options, job, ranks, reference);
    reference.film = job.reference->film;
    reference.origin = fmt::format("{}, by {}", oneLine(*options.reference),
                                   job.reference->settings.at("generator"));
    return true;
}

/// Renders what is compared. False if it was interrupted. Only rank 0 has images.
bool renderAll(const CompareOptions& options, const CompareJob& job, const Ranks& ranks,
               Comparison& comparison) {
    if (!findReference(options, job, ranks, comparison.reference)) return false;
    for (const std::string& name : options.generators) {
        GeneratorRun run(options, job, ranks, name, options.scene.seed);
        comparison.generators.push_back({name, {}});
        for (const uint32_t samples : options.spp) {
            if (!run.render(samples)) return false;
            if (!ranks.isRoot()) continue;
            if (comparison.crop.width == 0) {
                comparison.crop = worstCrop(run.film(), comparison.reference.film);
            }
            comparison.generators.back().images.push_back(
                {samples, render::filmError(run.film(), comparison.reference.film), run.seconds(),
                 enlarged(run.film(), comparison.crop)});
        }
    }
    return true;
}

std::string commandOf(const CompareOptions& options, ImageSize size) {
    return fmt::format("wellstrat compare {} --generators {} --spp {} {} -o {}",
                       sceneArguments(options.scene, size), fmt::join(options.generators, ","),
                       fmt::join(options.spp, ","),
                       options.reference
                           ? "--reference " + shellWord(*options.reference)
                           : fmt::format("--reference-spp {}", referenceSamples(options)),
                       shellWord(options.output));
}

int run(const CompareOptions& options, const Ranks& ranks, CompareJob& job) {
    Comparison comparison{oneLine(options.scene.scene),
                          {render::Film(job.size.width, job.size.height), "", {}},
                          {0, 0, 0, 0},
                          {}};
    if (!renderAll(options, job, ranks, comparison)) {
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
            if (!parseNumber(text, {1, kMostSamples}, count)) {
                throw CLI::ValidationError(
                    "--spp",
                    fmt::format("not a whole number from 1 to {}: '{}'", kMostSamples, text));
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
    CLI::App* const command =
        app.add_subcommand("compare", "Compare generators by the error of their images, as a page");
    const auto options = std::make_shared<CompareOptions>();
    addSceneOptions(*command, options->scene)->required();
    command->add_option("--generators", options->generators, "What is compared [pmj,random]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,NAME");
    addCounts(*command, options->spp);
    CLI::Option* const reference =
        command
            ->add_option("--reference", options->reference,
                         "An image of `wellstrat render` with another --seed")
            ->type_name("FILE.exr");
    addNumber(*command, "--reference-spp", options->referenceSpp, {1, kMaxWord},
              "Samples of the reference [8 times the most of --spp]")
        ->excludes(reference);
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
