// SPDX-License-Identifier: Apache-2.0
//
// A square as an OBJ file with a material library, for tests of readers.

#pragma once

#include "scene_files.h"

#include <string>

namespace wellstrat::render {

constexpr auto kSquareObj = R"(mtllib scene.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl first
f 1/1 2/2 3/3 4/4
)";

/// The square with what the library says of its material.
inline Scene readSquareObj(const TempFolder& folder, const std::string& material) {
    folder.write("scene.mtl", "newmtl first\n" + material);
    return readScene(folder.write("scene.obj", kSquareObj));
}

} // namespace wellstrat::render
