// SPDX-License-Identifier: Apache-2.0
//
// The two parts of a glTF file.

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wellstrat::render {

/// Views of the bytes that they were found in.
struct GltfParts {
    std::string_view json;
    std::optional<std::string_view> binary;
};

/// Takes a .glb apart, known by its first four bytes: glTF 2.0 specification, section 4.4; all else
/// is JSON. Throws std::runtime_error if it is shorter than its header says or of another version.
GltfParts gltfParts(std::string_view bytes);

} // namespace wellstrat::render
