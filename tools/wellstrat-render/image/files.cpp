// SPDX-License-Identifier: Apache-2.0

#include "files.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"

#include "renderer/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace wellstrat::cli {

ImageFiles::ImageFiles(const std::string& option, const std::vector<std::string>& paths,
                       const render::Display& display)
    : paths_(paths), display_(display) {
    for (const std::string& path : paths) {
        suffixes_.push_back(requireSuffix(option, path, {".exr", ".png", ".jpg", ".jpeg", ".hdr"}));
    }
    for (const std::string& path : paths) files_.emplace_back(path);
}

bool ImageFiles::keepSums() const {
    return std::find(suffixes_.begin(), suffixes_.end(), ".exr") != suffixes_.end();
}

void ImageFiles::write(const render::FilmPart& part) {
    std::exception_ptr failure;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        try {
            write(i, part);
        } catch (const std::exception&) {
            if (!failure) failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
}

void ImageFiles::write(std::size_t i, const render::FilmPart& part) {
    try {
        files_[i].write(suffixes_[i] == ".exr"
                            ? render::encodePart(part)
                            : render::encodePicture(part.film, suffixes_[i], display_));
        files_[i].commit();
    } catch (const CliError&) {
        throw;
    } catch (const std::exception& error) {
        throw CliError(fmt::format("cannot write '{}': {}", paths_[i], messageOf(error)));
    }
}

render::FilmPart readImage(const std::string& path) {
    try {
        return render::readPart(path);
    } catch (const std::runtime_error& error) {
        throw CliError(fmt::format("cannot read '{}': {}", path, error.what()));
    }
}

} // namespace wellstrat::cli
