// SPDX-License-Identifier: Apache-2.0

#include "options.h"

#include "common/command_line/options.h"

#include <fmt/format.h>

#include <string_view>

namespace wellstrat::cli {
namespace {

void addSamples(CLI::App& command, std::optional<SampleSpan>& samples) {
    const auto read = [&samples](const std::string& text) {
        const std::size_t colon = text.find(':');
        uint64_t begin = 0, end = 0;
        if (colon == std::string::npos ||
            !parseNumber(std::string_view(text).substr(0, colon), {0, kMaxWord - 1}, begin) ||
            !parseNumber(std::string_view(text).substr(colon + 1), {begin + 1, kMaxWord}, end)) {
            throw CLI::ValidationError(
                "--samples", fmt::format("not A:B with whole numbers A below B: '{}'", text));
        }
        samples = SampleSpan{static_cast<uint32_t>(begin), static_cast<uint32_t>(end)};
    };
    command
        .add_option_function<std::string>("--samples", read,
                                          "Only samples A to B - 1 of each pixel")
        ->type_name("A:B");
}

void addFrames(CLI::App& command, RenderOptions& options) {
    addNumber(command, "--frame", options.frame, {0, kMaxWord},
              "Frame F of a sequence: its samples go on where those of F - 1 end [0]");
    addNumber(command, "--frames", options.frames, {1, kMostFrames},
              "As many frames, from --frame on; %04d in -o is their number [1]");
    addReal(command, "--orbit", options.orbit, {-360, 360},
            "Degrees around --look-at [the scene's middle] from frame to frame");
}

} // namespace

void addRenderOptions(CLI::App& command, RenderOptions& options) {
    addSceneOptions(command, options.scene);
    command.add_flag("--list", options.list, "Print the built-in scenes and exit");
    command
        .add_option("-o,--output", options.outputs,
                    "The image: FILE.exr, .png, .jpg or .hdr; may be given several times")
        ->allow_extra_args(false)
        ->type_name("FILE");
    addDisplayOptions(command, options.display);
    command.add_flag("--transparent", options.scene.transparent,
                     "What is behind the scene is transparent in .png and .exr");
    command
        .add_option("--generator", options.generator,
                    "What draws the samples: pmj, joint, long, blue or random [pmj]")
        ->type_name("NAME");
    addNumber(command, "--spp", options.spp, {1, kMaxWord}, "Samples of each pixel [64]");
    addSamples(command, options.samples);
    addFrames(command, options);
    addReal(command, "--noise", options.noise, {1e-6, 1e6},
            "Error at which pixels are good enough");
    addReal(command, "--time-limit", options.timeLimit, {0, 1e9}, "Seconds to render for");
    command
        .add_option("--checkpoint", options.checkpoint,
                    "Save the state to FILE.exr now and then, and when it is interrupted")
        ->type_name("FILE");
    addNumber(command, "--save-every", options.saveEvery, {0, 86400},
              "Seconds between checkpoints [30]");
    command.add_option("--resume", options.resume, "Go on from this image or checkpoint")
        ->type_name("FILE");
}

} // namespace wellstrat::cli
