// SPDX-License-Identifier: Apache-2.0

#include "picture.h"

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/output/output_file.h"
#include "frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

void saveCheckpoint(const RenderOptions& options, RenderedPicture& picture,
                    const render::FilmPart& part) {
    const std::optional<std::string> path = checkpointOf(options, picture.frame);
    if (!path) return;
    picture.checkpoints.attempt([&] { ImageFiles("--checkpoint", {*path}).write(part); });
}

/// What `picture` has when its pixels have the samples of `film`.
render::FilmPart partOf(const RenderedPicture& picture, render::Film film) {
    render::FilmPart part = render::makePart(std::move(film), picture.plan.firstSample,
                                             picture.plan.endSample, picture.part.settings);
    part.firstSample = picture.part.firstSample;
    return part;
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

bool hasSamples(const render::Film& film) {
    return std::any_of(film.pixels().begin(), film.pixels().end(),
                       [](const render::PixelSums& sums) { return sums.count > 0; });
}

void sayInvalid(const render::Film& film) {
    uint64_t invalid = 0;
    for (const render::PixelSums& sums : film.pixels()) invalid += sums.invalid;
    if (invalid == 0) return;
    say("{} samples were NaN or infinite and count as black", invalid);
}

/// What a run took, in all ranks together.
struct RunCost {
    double seconds;
    uint64_t segments;
};

/// "6.20 million", or a whole number of thousands or of ones.
std::string rateText(double rate) {
    if (rate >= 1e6) return fmt::format("{:.2f} million", rate * 1e-6);
    return rate >= 1e4 ? fmt::format("{:.0f} thousand", rate * 1e-3) : fmt::format("{:.0f}", rate);
}

void sayDone(const RenderOptions& options, const RenderedPicture& picture, const render::Film& film,
             const RunCost& cost) {
    const std::string frame =
        isSequence(options) ? fmt::format(", frame {}", picture.frame) : std::string();
    writeMessage(STDOUT_FILENO,
                 fmt::format("{}{}: {}x{} pixels, {} {} each, {:.2f} s, {} path "
                             "segments a second\n",
                             oneLine(options.scene.scene), frame, film.width(), film.height(),
                             countText(film), countText(film) == "1" ? "sample" : "samples",
                             cost.seconds,
                             rateText(static_cast<double>(cost.segments) / cost.seconds)));
}

void sayStopped(const RenderOptions& options, const RenderedPicture& picture,
                const render::Film& film, RenderEnd end) {
    const std::string frame =
        isSequence(options) ? fmt::format(" in frame {}", picture.frame) : std::string();
    const bool isSaved =
        picture.files->keepSums() || (options.checkpoint && !picture.checkpoints.failing());
    say("{}{} with {} of {} samples a pixel{}",
        end == RenderEnd::interrupted ? "interrupted" : "time is up", frame, countText(film),
        picture.plan.endSample - picture.plan.firstSample, isSaved ? "; --resume goes on" : "");
}

/// Writes what is there: if the run has not come to its end, or the files cannot be written, to the
/// checkpoint too.
void writeAll(const RenderOptions& options, RenderedPicture& picture, const render::FilmPart& part,
              bool finished) {
    if (!finished) saveCheckpoint(options, picture, part);
    try {
        picture.files->write(part);
    } catch (const std::exception&) {
        if (finished) saveCheckpoint(options, picture, part);
        throw;
    }
}

/// What rank 0 does after the run.
void finish(const RenderOptions& options, RenderedPicture& picture, RenderEnd end,
            const RunCost& cost) {
    const render::FilmPart part = partOf(picture, std::move(picture.part.film));
    writeAll(options, picture, part, end == RenderEnd::finished);
    sayInvalid(part.film);
    if (end == RenderEnd::finished) {
        sayIfInvisible(part.film, displayOf(options.display));
        sayDone(options, picture, part.film, cost);
    } else {
        sayStopped(options, picture, part.film, end);
    }
}

/// What a process that is alone does if the run failed and some samples are there. Throws what
/// tells of both.
[[noreturn]] void saveFailed(const RenderOptions& options, RenderedPicture& picture,
                             const std::exception& error) {
    const render::FilmPart part = partOf(picture, std::move(picture.part.film));
    writeAll(options, picture, part, false);
    throw CliError(fmt::format("{}; the image is written with {} of {} samples a pixel",
                               messageOf(error), countText(part.film),
                               picture.plan.endSample - picture.plan.firstSample));
}

} // namespace

void tryFiles(const RenderOptions& options, uint64_t frame) {
    const ImageFiles files("--output", outputsOf(options, frame));
    if (const std::optional<std::string> checkpoint = checkpointOf(options, frame)) {
        requireSuffix("--checkpoint", *checkpoint, {".exr"});
        const OutputFile trial(*checkpoint);
    }
}

RenderedPicture beginPicture(const RenderOptions& options, uint64_t frame, ImageSize size,
                             const std::map<std::string, std::string>& settings, bool root) {
    const SampleSpan span = samplesOf(options, frame);
    const std::string label = isSequence(options) ? fmt::format("frame {}", frame) : "render";
    render::FilmPart part{render::Film(size.width, size.height),
                          {{span.begin, span.end, {}}},
                          settings,
                          firstSampleOf(options, frame)};
    return {frame,
            {span.begin, span.end, options.noise, options.timeLimit, label},
            std::move(part),
            root ? std::make_unique<ImageFiles>("--output", outputsOf(options, frame),
                                                displayOf(options.display))
                 : nullptr};
}

void resumePicture(const RenderOptions& options, RenderedPicture& picture, render::FilmPart part) {
    const auto refuse = [&options](const std::string& reason) {
        return CliError(fmt::format("--resume: '{}' {}", *options.resume, reason));
    };
    const render::FilmPart& fresh = picture.part;
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
    picture.part.film = std::move(part.film);
}

RenderEnd renderPicture(const RenderOptions& options, const render::Renderer& renderer,
                        const Ranks& ranks, RenderedPicture& picture) {
    const auto start = std::chrono::steady_clock::now();
    const uint64_t segmentsBefore = renderer.segments();
    std::optional<double> savePeriod;
    if (options.checkpoint) savePeriod = static_cast<double>(options.saveEvery);
    RenderEnd end;
    try {
        end = runRender(renderer, picture.plan, ranks, picture.part.film, savePeriod,
                        [&](const render::Film& film) {
                            saveCheckpoint(options, picture, partOf(picture, film));
                        });
    } catch (const std::exception& error) {
        if (ranks.size() == 1 && hasSamples(picture.part.film)) saveFailed(options, picture, error);
        throw;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::vector<uint64_t> segments{renderer.segments() - segmentsBefore};
    ranks.sumAtRoot(segments);
    if (ranks.isRoot()) finish(options, picture, end, {seconds.count(), segments[0]});
    return end;
}

} // namespace wellstrat::cli
