// SPDX-License-Identifier: Apache-2.0
//
// glTF's KHR_materials_emissive_strength, which Assimp 5.2 does not know.

#pragma once

#include <optional>
#include <string>

namespace wellstrat::render {

/// The bytes of a .gltf or .glb file with the strength of each material multiplied into its
/// emissive factor. None if there is nothing to do, or if the bytes are no valid glTF: that is
/// Assimp's to report.
std::optional<std::string> withEmissiveStrengths(const std::string& bytes);

} // namespace wellstrat::render
