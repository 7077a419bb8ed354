// SPDX-License-Identifier: Apache-2.0
//
// wellstrat render: draws a scene.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/options.h"
#include "common/command_line/render_commands.h"
#include "common/output/output_file.h"
#include "common/ranks/run_on_ranks.h"
#include "image/files.h"
#include "image/passes.h"
#include "image/sampling.h"
#include "options.h"
#include "scene/load.h"

#include "renderer/film_file.h"
#include "renderer/scene_fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Writes FILE.exr, which shows the image and keeps the exact sums of its samples, so that other
samples can be added later; FILE.png (sRGB) and FILE.hdr are pictures only. An image is the same
bits for any number of threads and processes, and in how many pieces it was rendered:
--samples A:B renders some of the samples of each pixel, `wellstrat merge` puts such parts together,
and mpirun shares the tiles of one image.

Ctrl-C and --time-limit write what is there; --resume FILE goes on from such an image, or from a
checkpoint, with the same command, also with more --spp.

--generator joint stratifies the first domains of each path together, which pays from some 64
samples a pixel on. --generator blue does, too, and stratifies the samples of neighboring pixels
together: their errors cancel when the image is seen from afar, filtered or denoised, from one
sample a pixel on.

--noise E stops pixels whose estimated standard error, and that of the pixels around them, is at
most E times their luminance plus 0.01 (0.05: 5 %). It looks after 16, 32, 64, ... samples, and
takes at most --spp. Pixels that missed something rare stop too early and too dark: the image is
biased. The estimate knows nothing of stratification, so the true error is mostly smaller.

Examples:
  wellstrat render --list
  wellstrat render cornell -o cornell.exr -o cornell.png --spp 256
  wellstrat render model.glb -o model.exr --environment sky.hdr --size 640x480 --time-limit 60
  wellstrat render veach -o veach.exr --spp 4096 --checkpoint veach-part.exr
  wellstrat render veach -o veach.exr --spp 4096 --resume veach-part.exr
  wellstrat render lens -o a.exr --samples 0:512
  mpirun -n 4 wellstrat render cornell -o cornell.exr --spp 4096

Exit codes: 0 done, 2 error, 130 interrupted.
)";

/// What is rendered, and onto what.
struct RenderJob {
    std::unique_ptr<tbb::global_control> threads;
    std::unique_ptr<render::Scene> scene;
    std::unique_ptr<render::Renderer> renderer;
    RenderPlan plan;
    render::FilmPart part;
    std::unique_ptr<ImageFiles> files; ///< of rank 0
};

constexpr uint64_t kDefaultSpp = 64;

SampleSpan spanOf(const RenderOptions& options) {
    const SampleSpan span = options.samples.value_or(
        SampleSpan{0, static_cast<uint32_t>(options.spp.value_or(kDefaultSpp))});
    if (options.spp && span.end > *options.spp) {
        throw CliError(fmt::format("--samples {}:{} goes beyond the {} samples of --spp",
                                   span.begin, span.end, *options.spp));
    }
    checkSamples(options.scene, options.samples ? "--samples" : "--spp", span.end);
    if (options.noise && span.begin > 0) {
        throw CliError("--noise decides by all samples of a pixel, so --samples must begin at 0");
    }
    return span;
}

std::map<std::string, std::string> settingsOf(const RenderOptions& options,
                                              const render::Scene& scene) {
    auto settings =
        imageSettings(options.scene, render::sceneFingerprint(scene), options.generator);
    if (options.noise) settings["noise"] = fmt::format("{}", *options.noise);
    return settings;
}

/// The film of --resume, if it is one that `fresh` can grow from.
render::Film resumedFilm(const std::string& path, const render::FilmPart& fresh) {
    render::FilmPart part = readImage(path);
    const auto refuse = [&path](const std::string& reason) {
        return CliError(fmt::format("--resume: '{}' {}", path, reason));
    };
    const std::string difference = render::differingSetting(part.settings, fresh.settings);
    if (!difference.empty()) throw refuse("differs in: " + difference);
    if (part.film.width() != fresh.film.width() || part.film.height() != fresh.film.height()) {
        throw refuse(fmt::format("has {}x{} pixels, not {}x{}", part.film.width(),
                                 part.film.height(), fresh.film.width(), fresh.film.height()));
    }
    const render::SampleRange& wanted = fresh.ranges.front();
    if (part.ranges.size() > 1 || part.ranges.front().begin != wanted.begin) {
        throw refuse(
            fmt::format("does not have the samples from {} on, without gaps", wanted.begin));
    }
    uint32_t most = 0;
    for (const render::PixelSums& sums : part.film.pixels()) most = std::max(most, sums.count);
    if (most > wanted.end - wanted.begin) {
        throw refuse(fmt::format("has {} samples already, more than asked for", most));
    }
    return std::move(part.film);
}

/// Throws CliError if no checkpoint can be written.
void checkCheckpoint(const RenderOptions& options) {
    if (!options.checkpoint) return;
    requireSuffix("--checkpoint", *options.checkpoint, {".exr"});
    const OutputFile trial(*options.checkpoint);
}

RenderJob prepare(const RenderOptions& options, bool root) {
    const SampleSpan span = spanOf(options);
    const Generator* const generator =
        findGenerator("--generator", options.generator, renderGenerators()).generator;
    if (options.scene.scene.empty()) {
        throw CliError("a scene is required: a file, or one of --list");
    }
    if (options.outputs.empty()) throw CliError("-o FILE.exr is required");
    std::unique_ptr<ImageFiles> files;
    if (root) {
        files = std::make_unique<ImageFiles>("--output", options.outputs);
        checkCheckpoint(options);
    }

    auto scene = std::make_unique<render::Scene>(loadScene(options.scene));
    if (root) sayNotes(*scene);
    const ImageSize size = imageSize(options.scene, *scene);
    render::FilmPart part{render::Film(size.width, size.height),
                          {{span.begin, span.end, {}}},
                          settingsOf(options, *scene)};
    if (options.resume) part.film = resumedFilm(*options.resume, part);
    auto threads = limitThreads(options.scene);
    auto renderer = makeRenderer(options.scene, *scene, size, generator);
    return {std::move(threads),  std::move(scene),
            std::move(renderer), {span.begin, span.end, options.noise, options.timeLimit, "render"},
            std::move(part),     std::move(files)};
}

void saveCheckpoint(const RenderOptions& options, const render::FilmPart& part) {
    if (!options.checkpoint) return;
    ImageFiles file("--checkpoint", {*options.checkpoint});
    file.write(part);
    file.commit();
}

/// The least and the most samples of a pixel, such as "64" or "16 to 64".
std::string countText(const render::Film& film) {
    uint32_t least = std::numeric_limits<uint32_t>::max(), most = 0;
    for (const render::PixelSums& sums : film.pixels()) {
        least = std::min(least, sums.count);
        most = std::max(most, sums.count);
    }
    return least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
}

void sayInvalid(const render::Film& film) {
    uint64_t invalid = 0;
    for (const render::PixelSums& sums : film.pixels()) invalid += sums.invalid;
    if (invalid == 0) return;
    fmt::print(stderr, "wellstrat: {} samples were NaN or infinite and count as black\n", invalid);
}

/// What a run took, in all ranks together.
struct RunCost {
    double seconds;
    uint64_t segments;
};

/// What rank 0 does after the run. Returns the exit code.
int finish(const RenderOptions& options, RenderJob& job, RenderEnd end, RunCost cost) {
    const auto settings = job.part.settings;
    const render::FilmPart part = render::makePart(std::move(job.part.film), job.plan.firstSample,
                                                   job.plan.endSample, settings);
    if (end != RenderEnd::finished) saveCheckpoint(options, part);
    job.files->write(part);
    job.files->commit();
    sayInvalid(part.film);
    const std::string counts = countText(part.film);
    if (end == RenderEnd::finished) {
        const double speed = static_cast<double>(cost.segments) / cost.seconds * 1e-6;
        printText(
            fmt::format("{}: {}x{} pixels, {} samples each, {:.2f} s, {:.2f} million path "
                        "segments a second\n",
                        oneLine(options.scene.scene), part.film.width(), part.film.height(), counts,
                        cost.seconds, speed));
        return 0;
    }
    const bool interrupted = end == RenderEnd::interrupted;
    fmt::print(stderr, "wellstrat: {} with {} of {} samples a pixel{}\n",
               interrupted ? "interrupted" : "time is up", counts,
               job.plan.endSample - job.plan.firstSample,
               options.checkpoint || job.files->keepSums() ? "; --resume goes on" : "");
    return interrupted ? kExitInterrupted : 0;
}

int run(const RenderOptions& options, const Ranks& ranks, RenderJob& job) {
    const auto start = std::chrono::steady_clock::now();
    std::optional<double> savePeriod;
    if (options.checkpoint) savePeriod = static_cast<double>(options.saveEvery);
    const auto settings = job.part.settings;
    const RenderEnd end = runRender(
        *job.renderer, job.plan, ranks, job.part.film, savePeriod, [&](const render::Film& film) {
            saveCheckpoint(options, render::makePart(film, job.plan.firstSample, job.plan.endSample,
                                                     settings));
        });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::vector<uint64_t> segments{job.renderer->segments()};
    ranks.sumAtRoot(segments);
    const RunCost cost{seconds.count(), segments[0]};
    return ranks.isRoot() ? finish(options, job, end, cost) : 0;
}

int renderOnRanks(const RenderOptions& options) {
    if (options.list) {
        printText(sceneList());
        return 0;
    }
    return runOnRanks([&](const Ranks& ranks) { return prepare(options, ranks.isRoot()); },
                      [&](const Ranks& ranks, RenderJob& job) { return run(options, ranks, job); });
}

} // namespace

void addRender(CLI::App& app, int& exitCode) {
    CLI::App* const command = app.add_subcommand(kRender.name, kRender.description);
    const auto options = std::make_shared<RenderOptions>();
    addRenderOptions(*command, *options);
    command->footer(kExamples);
    command->callback([options, &exitCode] { exitCode = renderOnRanks(*options); });
}

} // namespace wellstrat::cli
