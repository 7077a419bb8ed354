// SPDX-License-Identifier: Apache-2.0
//
// Between Assimp's vectors and ours.

#pragma once

#include "affine.h"

#include <assimp/types.h>

namespace wellstrat::render {

inline Float3 toFloat3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

inline Affine toAffine(const aiMatrix4x4& m) {
    return {{m.a1, m.b1, m.c1}, {m.a2, m.b2, m.c2}, {m.a3, m.b3, m.c3}, {m.a4, m.b4, m.c4}};
}

} // namespace wellstrat::render
