// SPDX-License-Identifier: Apache-2.0
//
// Primitives that Draco has compressed.

#pragma once

#include "accessors.h"
#include "extensions.h"

#include <tiny_gltf.h>

#include <map>
#include <string>
#include <vector>

namespace wellstrat::render {

struct DracoPrimitive {
    std::map<std::string, Numbers> attributes; ///< by their names, as "POSITION"
    std::vector<uint32_t> corners;             ///< three a triangle
};

/// What the extension of a primitive, which must have it, stands for. Throws std::runtime_error,
/// with the name of the extension, if it cannot be decoded.
DracoPrimitive decodeDraco(const GltfDocument& document, const tinygltf::Primitive& primitive);

} // namespace wellstrat::render
