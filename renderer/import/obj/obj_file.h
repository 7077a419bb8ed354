// SPDX-License-Identifier: Apache-2.0
//
// What an OBJ file says: Wavefront's "Object Files (.obj)", appendix B1 of the manual of the
// Advanced Visualizer, http://paulbourke.net/dataformats/obj/.

#pragma once

#include "wellstrat/vector.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace wellstrat::render {

constexpr uint32_t kNoObjIndex = std::numeric_limits<uint32_t>::max();

/// Indices from 0; kNoObjIndex stands for what the file leaves out or does not have.
struct ObjCorner {
    uint32_t position, uv, normal;
};

struct ObjFace {
    uint64_t end;      ///< its corners begin where those of the face before it end
    uint32_t material; ///< in `ObjFile::materials`
};

struct ObjFile {
    std::vector<Float3> positions;
    std::vector<Float3> colors; ///< of positions, as they are stored; empty: none has one
    std::vector<Float2> uvs;
    std::vector<Float3> normals;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<std::string> materials; ///< their names; the first, "", is that before all names
    std::vector<std::string> libraries; ///< what follows each "mtllib"
    uint64_t otherElements = 0;         ///< points and lines
    bool hasFreeForms = false;          ///< curves and surfaces
};

/// Any text gives a file: what is no statement is skipped, numbers that are none are NaN. Corners
/// refer to what the file has.
ObjFile parseObj(std::string text);

} // namespace wellstrat::render
