// SPDX-License-Identifier: Apache-2.0
//
// One picture in work: begun or resumed, rendered, and written.

#pragma once

#include "common/output/savings.h"
#include "common/ranks/ranks.h"
#include "image/files.h"
#include "image/passes.h"
#include "options.h"
#include "scene/options.h"

#include "renderer/film_part.h"
#include "renderer/render.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace wellstrat::cli {

struct RenderedPicture {
    uint64_t frame;
    RenderPlan plan;
    render::FilmPart part;             ///< what is there of it
    std::unique_ptr<ImageFiles> files; ///< of rank 0
    Savings checkpoints = {};
};

/// Throws CliError if a file of this frame cannot be written. Leaves nothing behind.
void tryFiles(const RenderOptions& options, uint64_t frame);

/// A black picture. The files are opened if this is rank 0. Throws CliError.
RenderedPicture beginPicture(const RenderOptions& options, uint64_t frame, ImageSize size,
                             const std::map<std::string, std::string>& settings, bool root);

/// Gives a picture that has begun the samples of `part`, which --resume names. Throws CliError if
/// that is no part of this picture, from its first sample on.
void resumePicture(const RenderOptions& options, RenderedPicture& picture, render::FilmPart part);

/// Adds what is missing, with checkpoints on the way, writes the files, and says what was done.
/// Leaves `picture` without a film. Returns how it ended, the same in all ranks. If it throws, as
/// for lack of memory, what a single process has is written nevertheless, and if the files cannot
/// be written, the checkpoint.
RenderEnd renderPicture(const RenderOptions& options, const render::Renderer& renderer,
                        const Ranks& ranks, RenderedPicture& picture);

} // namespace wellstrat::cli
