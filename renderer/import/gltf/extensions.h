// SPDX-License-Identifier: Apache-2.0
//
// Which extensions of glTF are read.

#pragma once

#include "../notes.h"

#include <string>
#include <vector>

namespace wellstrat::render {

/// Throws std::runtime_error, with their names, if there are required extensions that are not read,
/// and adds a note for each used one that is not.
void checkExtensions(const std::vector<std::string>& used, const std::vector<std::string>& required,
                     Notes& notes);

} // namespace wellstrat::render
