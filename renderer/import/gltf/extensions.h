// SPDX-License-Identifier: Apache-2.0
//
// Which extensions of glTF are read.

#pragma once

#include "../notes.h"

#include <string>
#include <vector>

namespace wellstrat::render {

constexpr auto kDracoExtension = "KHR_draco_mesh_compression";
constexpr auto kMeshoptExtension = "EXT_meshopt_compression";

/// Can what they compress be read?
#if WELLSTRAT_DRACO
constexpr bool kHasDraco = true;
#else
constexpr bool kHasDraco = false;
#endif
#if WELLSTRAT_MESHOPTIMIZER
constexpr bool kHasMeshopt = true;
#else
constexpr bool kHasMeshopt = false;
#endif

/// Throws std::runtime_error, with their names, if there are required extensions that are not read,
/// and adds a note for each used one that is not.
void checkExtensions(const std::vector<std::string>& used, const std::vector<std::string>& required,
                     Notes& notes);

} // namespace wellstrat::render
