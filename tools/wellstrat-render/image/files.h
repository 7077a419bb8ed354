// SPDX-License-Identifier: Apache-2.0
//
// The image files that a command writes.

#pragma once

#include "common/output/output_file.h"

#include "renderer/film_part.h"
#include "renderer/picture_file.h"

#include <deque>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// Files of one image: .exr with the exact sums, .png, .jpg and .hdr as pictures only. Throws
/// CliError if a name has none of these suffixes or cannot be written.
class ImageFiles {
public:
    /// `option` is named in messages.
    ImageFiles(const std::string& option, const std::vector<std::string>& paths,
               const render::Display& display = {});

    /// Whether one of the files is .exr, and so can be resumed.
    bool keepSums() const;

    /// Writes all of them, each under its name as soon as it is complete. Throws the first error
    /// when the others are written.
    void write(const render::FilmPart& part);

private:
    void write(std::size_t i, const render::FilmPart& part);

    std::vector<std::string> paths_, suffixes_;
    render::Display display_;
    std::deque<OutputFile> files_;
};

/// Reads an image with its sums. Throws CliError, which names the file.
render::FilmPart readImage(const std::string& path);

} // namespace wellstrat::cli
