// SPDX-License-Identifier: Apache-2.0
//
// The options that say how pictures for the eye look.

#pragma once

#include "renderer/film.h"
#include "renderer/picture_file.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>

namespace wellstrat::cli {

struct DisplayOptions {
    std::optional<double> exposure; ///< stops
    std::string tonemap = "none";   ///< or "filmic"
};

/// `options` must outlive `command`.
void addDisplayOptions(CLI::App& command, DisplayOptions& options);

render::Display displayOf(const DisplayOptions& options);

/// Warns if the picture is almost black or almost white.
void sayIfInvisible(const render::Film& film, const render::Display& display);

} // namespace wellstrat::cli
