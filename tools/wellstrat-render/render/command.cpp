// SPDX-License-Identifier: Apache-2.0
//
// wellstrat render: draws a scene.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/messages.h"
#include "common/command_line/render_commands.h"
#include "common/output/output_file.h"
#include "common/ranks/run_on_ranks.h"
#include "frames.h"
#include "image/files.h"
#include "image/sampling.h"
#include "options.h"
#include "picture.h"
#include "scene/load.h"

#include "renderer/scene_fingerprint.h"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Writes FILE.exr, which shows the image and keeps the exact sums of its samples, so that other
samples can be added later; FILE.png, FILE.jpg (both sRGB) and FILE.hdr are pictures only. An image
is the same bits for any number of threads and processes, and in how many pieces it was rendered:
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

--frames N renders a sequence: frames F to F+N-1, F from --frame, to files named by the %04d in -o.
Frame F has samples F*spp to F*spp+spp-1 of each pixel: going on without gaps, the frames of a
sequence are stratified together, which the average of several shows (docs/rendering.md). --samples
counts from the frame's first sample; --orbit moves the camera; --time-limit is for all frames. With
--resume, the frames before the one of that image or checkpoint count as done.

Examples:
  wellstrat render --list
  wellstrat render cornell -o cornell.exr -o cornell.png --spp 256
  wellstrat render model.glb -o model.exr --environment sky.hdr --size 640x480 --time-limit 60
  wellstrat render model.glb -o model.png --studio on --exposure 0.5 --tonemap filmic
  wellstrat render veach -o veach.exr --spp 4096 --checkpoint veach-part.exr
  wellstrat render veach -o veach.exr --spp 4096 --resume veach-part.exr
  wellstrat render lens -o a.exr --samples 0:512
  wellstrat render lens -o lens.%04d.png --spp 4 --frames 24 --orbit 1
  wellstrat render lens -o lens.%04d.png --spp 4 --frame 7 --orbit 1
  mpirun -n 4 wellstrat render cornell -o cornell.exr --spp 4096

Exit codes: 0 done, 2 error, 130 interrupted.
)";

/// What is rendered: a picture after the other, of one scene.
struct RenderJob {
    std::unique_ptr<tbb::global_control> threads;
    std::unique_ptr<render::Scene> scene; ///< with the camera of the picture in work
    std::unique_ptr<render::Renderer> renderer;
    render::Camera firstCamera; ///< of frame 0
    FrameSpan frames;
    ImageSize size;
    std::map<std::string, std::string> settings; ///< of the picture in work
    RenderedPicture picture;                     ///< in work
};

std::map<std::string, std::string> settingsOf(const RenderOptions& options,
                                              const render::Scene& scene) {
    auto settings =
        imageSettings(options.scene, render::sceneFingerprint(scene), options.generator);
    if (options.noise) settings["noise"] = fmt::format("{}", *options.noise);
    return settings;
}

/// Gives the scene its camera of a frame.
void moveCamera(const RenderOptions& options, const render::Camera& firstCamera, uint64_t frame,
                render::Scene& scene) {
    if (!options.orbit) return;
    scene.camera = orbitedCamera(options.scene, scene, firstCamera,
                                 *options.orbit * static_cast<double>(frame));
}

/// The frame that `part`, the image of --resume, belongs to by its samples; the first one, which
/// will refuse it, if it is none.
uint64_t resumedFrame(const RenderOptions& options, const FrameSpan& frames,
                      const render::FilmPart& part) {
    for (uint64_t frame = frames.first; frame < frames.end; ++frame) {
        if (part.ranges.front().begin == samplesOf(options, frame).begin) return frame;
    }
    return frames.first;
}

RenderJob prepare(const RenderOptions& options, bool root) {
    const FrameSpan frames = framesOf(options);
    const Generator* const generator =
        findGenerator("--generator", options.generator, renderGenerators()).generator;
    if (options.scene.scene.empty()) {
        throw CliError("a scene is required: a file, or one of --list");
    }
    if (options.outputs.empty()) throw CliError("-o FILE.exr is required");
    for (uint64_t frame = frames.first; root && frame < frames.end; ++frame) {
        tryFiles(options, frame);
    }

    auto scene = std::make_unique<render::Scene>(loadScene(options.scene));
    if (root) sayNotes(*scene);
    const ImageSize size = imageSize(options.scene, *scene);
    const render::Camera firstCamera = *scene->camera;
    std::optional<render::FilmPart> resumed;
    if (options.resume) resumed = readImage(*options.resume);
    const uint64_t frame = resumed ? resumedFrame(options, frames, *resumed) : frames.first;
    moveCamera(options, firstCamera, frame, *scene);
    auto settings = settingsOf(options, *scene);
    RenderedPicture picture = beginPicture(options, frame, size, settings, root);
    if (resumed) resumePicture(options, picture, std::move(*resumed));
    auto threads = limitThreads(options.scene);
    auto renderer = makeRenderer(options.scene, *scene, size, generator);
    return {std::move(threads),  std::move(scene),  std::move(renderer), firstCamera, frames, size,
            std::move(settings), std::move(picture)};
}

/// Begins the picture after the one that is done, with the seconds that are left.
void beginNext(const RenderOptions& options, RenderJob& job, bool root, double seconds) {
    const uint64_t frame = job.picture.frame + 1;
    if (options.orbit) {
        moveCamera(options, job.firstCamera, frame, *job.scene);
        job.renderer->setCamera(*job.scene->camera);
        job.settings = settingsOf(options, *job.scene);
    }
    job.picture = beginPicture(options, frame, job.size, job.settings, root);
    if (options.timeLimit) job.picture.plan.timeLimit = *options.timeLimit - seconds;
}

int run(const RenderOptions& options, const Ranks& ranks, RenderJob& job) {
    const auto start = std::chrono::steady_clock::now();
    if (ranks.isRoot() && job.picture.frame > job.frames.first) {
        say("goes on with frame {}; those before it stay as they are", job.picture.frame);
    }
    for (;;) {
        const RenderEnd end = renderPicture(options, *job.renderer, ranks, job.picture);
        if (end == RenderEnd::interrupted) return kExitInterrupted;
        if (end == RenderEnd::timeIsUp || job.picture.frame + 1 == job.frames.end) return 0;
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        if (options.timeLimit && ranks.any(seconds.count() >= *options.timeLimit)) {
            if (ranks.isRoot()) {
                say("time is up after frame {}; --frame {} goes on", job.picture.frame,
                    job.picture.frame + 1);
            }
            return 0;
        }
        beginNext(options, job, ranks.isRoot(), seconds.count());
    }
}

int renderOnRanks(const RenderOptions& options) {
    if (options.list) {
        if (launchedRank() == 0) printText(sceneList());
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
