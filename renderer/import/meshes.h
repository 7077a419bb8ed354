// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's meshes to ours.

#pragma once

#include "../scene.h"

#include <assimp/mesh.h>

#include <cstdint>

namespace wellstrat::render {

/// Parts of meshes that cannot be rendered.
struct Dropped {
    uint64_t notFinite = 0;  ///< triangles with a corner that is NaN, infinite, or missing
    uint64_t tooFar = 0;     ///< other triangles with a corner beyond 1e9
    uint64_t degenerate = 0; ///< triangles without area
    uint64_t otherFaces = 0; ///< points and lines
};

/// The triangles of `source` as `toWorld` places them, without those that cannot be rendered, which
/// are counted. A mirroring transform keeps fronts in front. `uvSet` is the set of texture
/// coordinates to take, if the mesh has it. The material is left at 0.
Mesh importMesh(const aiMesh& source, const aiMatrix4x4& toWorld, unsigned uvSet, Dropped& dropped);

} // namespace wellstrat::render
