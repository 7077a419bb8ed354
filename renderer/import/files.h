// SPDX-License-Identifier: Apache-2.0
//
// The files that a scene is made of.

#pragma once

#include <string>
#include <utility>
#include <vector>

namespace wellstrat::render {

/// All bytes of a file. Throws std::runtime_error if it may not be read.
std::string contentOf(const std::string& path);

/// Finds the files that a scene file names, and remembers which.
class FileFinder {
public:
    /// `folder` is that of the scene file, which relative paths start from.
    explicit FileFinder(std::string folder) : folders_{std::move(folder)} {}

    /// Looks in another folder, too, where those before do not have a file.
    void lookIn(std::string folder) { folders_.push_back(std::move(folder)); }

    /// The path of the file that a scene means by `name`: those written under Windows have
    /// backslashes, those of the web percent signs. Throws std::runtime_error if there is none.
    std::string find(const std::string& name);

    /// Remembers a file that was found in another way.
    void add(std::string path) { found_.push_back(std::move(path)); }

    std::vector<std::string> take() { return std::move(found_); }

private:
    std::vector<std::string> folders_;
    std::vector<std::string> found_;
};

} // namespace wellstrat::render
