// SPDX-License-Identifier: Apache-2.0
//
// From the faces of OBJ files to meshes.

#pragma once

#include "../../scene.h"
#include "obj_file.h"

#include <vector>

namespace wellstrat::render {

/// One mesh for the faces of a material that have normals, and one for the others, in the order of
/// their first faces. Colors of vertices are decoded from sRGB. Corners of triangles may be any
/// numbers.
std::vector<Mesh> meshesOf(const ObjFile& file);

} // namespace wellstrat::render
