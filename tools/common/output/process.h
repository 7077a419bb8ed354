// SPDX-License-Identifier: Apache-2.0
//
// Child processes, without a shell.

#pragma once

#include <string>
#include <vector>

namespace wellstrat::cli {

/// Runs arguments[0], looked up on PATH, with this argument vector and waits for it. Its standard
/// input is empty; its output, both streams, goes to the open file `output`. Returns the exit code,
/// or 128 plus the number of the signal that ended it. Throws std::system_error if it cannot be
/// started: std::errc::no_such_file_or_directory when there is no such program.
int runProcess(const std::vector<std::string>& arguments, int output);

} // namespace wellstrat::cli
