// SPDX-License-Identifier: Apache-2.0
//
// What of a PLY file can be rendered.

#pragma once

#include "wellstrat/vector.h"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::render {

constexpr uint32_t kNoPlyIndex = std::numeric_limits<uint32_t>::max();

/// Arrays of vertices beside `positions` are as long, or empty.
struct PlyFile {
    std::vector<Float3> positions;
    std::vector<Float3> normals;
    std::vector<Float3> colors;     ///< linear
    std::vector<Float2> uvs;        ///< from the lower left corner
    std::vector<uint32_t> corners;  ///< of faces, below positions.size() or kNoPlyIndex
    std::vector<uint64_t> faceEnds; ///< a face's corners begin where those of the one before end
    std::vector<Float2> cornerUvs;  ///< of `corners`, instead of `uvs`; empty if there are none
    std::string texture;            ///< the name of the picture for them; may be empty
    bool hasFaceColors = false;     ///< which are not read
    uint64_t otherElements = 0;     ///< edges, and the points of a file without faces
};

/// Reads "vertex" with x y z, nx ny nz, (u v), (s t), (texture_u texture_v) or (texture_s
/// texture_t), and red green blue; "face" with vertex_indices or vertex_index and texcoord; and
/// "tristrips", as faces. Other elements and properties are skipped. Integer colors are in sRGB, 1
/// being the largest integer of their type, floats are linear. The texture is that of a comment
/// "TextureFile NAME", which MeshLab writes. Throws std::runtime_error with one line if the header
/// is wrong, or the file ends early.
PlyFile parsePly(std::string_view file);

} // namespace wellstrat::render
