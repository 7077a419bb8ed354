// SPDX-License-Identifier: Apache-2.0
//
// Between Assimp's vectors and ours.

#pragma once

#include "wellstrat/vector.h"

#include <assimp/types.h>

#include <cmath>

namespace wellstrat::render {

inline Float3 toFloat3(const aiVector3D& v) { return {v.x, v.y, v.z}; }
inline aiVector3D toAssimp(Float3 v) { return {v.x, v.y, v.z}; }

inline bool isFinite(Float3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace wellstrat::render
