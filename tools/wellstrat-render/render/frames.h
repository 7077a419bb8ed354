// SPDX-License-Identifier: Apache-2.0
//
// The frames of a sequence: which samples they have, and what their files are called.

#pragma once

#include "options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// Frames first to end - 1. A picture that belongs to no sequence is frame 0.
struct FrameSpan {
    uint64_t first, end;
};

/// The frames that the options ask for. Throws CliError if options contradict each other, or if a
/// pixel has not so many samples.
FrameSpan framesOf(const RenderOptions& options);

/// Whether --frame or --frames is given.
bool isSequence(const RenderOptions& options);

/// The first sample of a frame: all frames before it have --spp of each pixel.
uint32_t firstSampleOf(const RenderOptions& options, uint64_t frame);

/// The samples of a frame that the options ask for: all, or those of --samples, counted from its
/// first one.
SampleSpan samplesOf(const RenderOptions& options, uint64_t frame);

/// The files of a frame: the names, with its number in the place of %04d. Throws CliError for
/// names of a sequence that have another place for a number, or none where there are --frames.
std::vector<std::string> outputsOf(const RenderOptions& options, uint64_t frame);

/// The same for the checkpoint, which needs no number: then it is always of the frame in work.
std::optional<std::string> checkpointOf(const RenderOptions& options, uint64_t frame);

} // namespace wellstrat::cli
