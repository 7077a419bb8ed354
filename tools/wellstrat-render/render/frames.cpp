// SPDX-License-Identifier: Apache-2.0

#include "frames.h"

#include "common/command_line/errors.h"
#include "image/sampling.h"

#include <fmt/format.h>

namespace wellstrat::cli {
namespace {

constexpr uint64_t kDefaultSpp = 64;

uint64_t sppOf(const RenderOptions& options) { return options.spp.value_or(kDefaultSpp); }

SampleSpan samplesInFrame(const RenderOptions& options) {
    return options.samples.value_or(SampleSpan{0, static_cast<uint32_t>(sppOf(options))});
}

void checkSpan(const RenderOptions& options) {
    const SampleSpan span = samplesInFrame(options);
    const bool sppCounts = options.spp || isSequence(options);
    if (sppCounts && span.end > sppOf(options)) {
        throw CliError(fmt::format("--samples {}:{} goes beyond the {} samples of --spp",
                                   span.begin, span.end, sppOf(options)));
    }
    checkSamples(options.scene, options.samples ? "--samples" : "--spp", span.end);
    if (options.noise && span.begin > 0) {
        throw CliError("--noise decides by all samples of a pixel, so --samples must begin at 0");
    }
}

void checkSequence(const RenderOptions& options, const FrameSpan& frames) {
    if (options.noise) {
        throw CliError(
            "--noise gives pixels different numbers of samples, which would leave gaps "
            "between frames; with --frame and --frames, all have --spp");
    }
    const uint64_t spp = sppOf(options);
    checkSamples(options.scene, "--spp", spp);
    const uint64_t most = mostSamples(options.scene) / spp;
    if (frames.end <= most) return;
    throw CliError(fmt::format(
        "{}: with {} samples of each pixel and --split {} there are frames 0 to {}, not to {}",
        options.frames ? "--frames" : "--frame", spp, options.scene.split, most - 1,
        frames.end - 1));
}

/// `path` with the number in the place of the one %0Nd, N from 1 to 9; `path` itself if there is no
/// percent sign and `needsNumber` is false.
std::string numbered(const std::string& option, const std::string& path, uint64_t number,
                     bool needsNumber) {
    const std::size_t percent = path.find('%');
    if (percent == std::string::npos && !needsNumber) return path;
    const bool isPlace = percent != std::string::npos && path.size() >= percent + 4 &&
                         path[percent + 1] == '0' && path[percent + 2] >= '1' &&
                         path[percent + 2] <= '9' && path[percent + 3] == 'd' &&
                         path.find('%', percent + 1) == std::string::npos;
    if (!isPlace) {
        throw CliError(
            fmt::format("{}: the number of a frame has one place in a file name, such "
                        "as %04d, which '{}' has not",
                        option, path));
    }
    return fmt::format("{}{:0{}}{}", path.substr(0, percent), number, path[percent + 2] - '0',
                       path.substr(percent + 4));
}

} // namespace

bool isSequence(const RenderOptions& options) { return options.frame || options.frames; }

FrameSpan framesOf(const RenderOptions& options) {
    checkSpan(options);
    const uint64_t first = options.frame.value_or(0);
    const FrameSpan frames{first, first + options.frames.value_or(1)};
    if (isSequence(options)) {
        checkSequence(options, frames);
    } else if (options.orbit) {
        throw CliError(
            "--orbit moves the camera from frame to frame: it needs --frames or --frame");
    }
    return frames;
}

uint32_t firstSampleOf(const RenderOptions& options, uint64_t frame) {
    return static_cast<uint32_t>(frame * sppOf(options));
}

SampleSpan samplesOf(const RenderOptions& options, uint64_t frame) {
    const uint32_t first = firstSampleOf(options, frame);
    const SampleSpan span = samplesInFrame(options);
    return {first + span.begin, first + span.end};
}

std::vector<std::string> outputsOf(const RenderOptions& options, uint64_t frame) {
    if (!isSequence(options)) return options.outputs;
    std::vector<std::string> paths;
    for (const std::string& path : options.outputs) {
        paths.push_back(numbered("--output", path, frame, options.frames.has_value()));
    }
    return paths;
}

std::optional<std::string> checkpointOf(const RenderOptions& options, uint64_t frame) {
    if (!options.checkpoint || !isSequence(options)) return options.checkpoint;
    return numbered("--checkpoint", *options.checkpoint, frame, false);
}

} // namespace wellstrat::cli
