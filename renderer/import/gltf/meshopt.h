// SPDX-License-Identifier: Apache-2.0
//
// Buffer views that meshoptimizer has compressed.

#pragma once

#include "extensions.h"

#include <tiny_gltf.h>

#include <string>
#include <string_view>

namespace wellstrat::render {

/// Which bytes a compressed buffer view has, and how it is compressed.
struct MeshoptView {
    explicit MeshoptView(const tinygltf::Value& extension);

    int buffer;
    std::size_t offset, length;
    std::size_t stride, count; ///< of what is compressed: `count` elements of `stride` bytes
    std::string mode, filter;
};

/// The bytes that `compressed` stands for: EXT_meshopt_compression, of which
/// https://github.com/KhronosGroup/glTF has the specification. Throws std::runtime_error, with the
/// name of the extension, if they cannot be decoded.
std::string decompressed(const MeshoptView& view, std::string_view compressed);

} // namespace wellstrat::render
