// SPDX-License-Identifier: Apache-2.0
//
// What must be done to glTF files before Assimp sees them.

#pragma once

#include <optional>
#include <string>

namespace wellstrat::render {

/// Does what Assimp 5.2 does not:
/// - multiplies the strength of each material, KHR_materials_emissive_strength, into its emissive
///   factor. Returns the new bytes; none if there is nothing to do, or if the bytes are no valid
///   JSON, which is Assimp's to report;
/// - refuses, with std::runtime_error, a .glb that is shorter than its header says.
std::optional<std::string> preparedGltf(const std::string& bytes);

} // namespace wellstrat::render
