// SPDX-License-Identifier: Apache-2.0
//
// Where the other files of the tools are: programs and modules that may be installed or not.

#pragma once

#include <optional>
#include <string>

namespace wellstrat::cli {

/// The file `name` in the folder of the running program, or in the folder of the tools' own files,
/// lib/wellstrat beside that one. Both move with the program. None if it is in neither.
std::optional<std::string> findOwnFile(const std::string& name);

/// The same, and for a program that is in neither the first one of that name on PATH.
std::optional<std::string> findProgram(const std::string& name);

} // namespace wellstrat::cli
