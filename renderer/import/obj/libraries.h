// SPDX-License-Identifier: Apache-2.0
//
// The material libraries of an OBJ file.

#pragma once

#include "../files.h"
#include "../notes.h"
#include "mtl_file.h"

#include <string>
#include <vector>

namespace wellstrat::render {

/// The materials of all libraries that `names` names: each is the rest of a line "mtllib", some
/// file names between blanks, which they may have, too. A note says which cannot be read.
std::vector<MtlMaterial> readLibraries(const std::vector<std::string>& names, FileFinder& files,
                                       Notes& notes);

} // namespace wellstrat::render
