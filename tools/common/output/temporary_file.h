// SPDX-License-Identifier: Apache-2.0
//
// Temporary files, also those that programs left behind which were killed.

#pragma once

#include <string>

namespace wellstrat::cli {

/// Makes a new file in `folder` and opens it for writing. Returns its descriptor, and its name in
/// `path`; -1, with errno, if that fails. The file is locked until the descriptor is closed: by
/// that the next run of a program tells files in work from those of processes that are gone, and
/// removes the latter from the folder first.
int openTemporaryFile(const std::string& folder, std::string& path);

} // namespace wellstrat::cli
