// SPDX-License-Identifier: Apache-2.0
//
// From the space of a mesh into the world.

#pragma once

#include "../scene.h"
#include "affine.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::render {

/// Parts of meshes that cannot be rendered.
struct Dropped {
    uint64_t notFinite = 0;  ///< triangles with a corner that is NaN, infinite, or missing
    uint64_t tooFar = 0;     ///< other triangles with a corner beyond 1e9
    uint64_t degenerate = 0; ///< triangles without area
    uint64_t otherFaces = 0; ///< points and lines

    /// "COUNT WHAT" of each kind of which there are some.
    std::vector<std::string> texts() const;
};

/// The triangles of `mesh` as `toWorld` places them, and the vertices they use, without triangles
/// that cannot be rendered, which are counted. Here alone the corners of triangles may be any
/// numbers. A mirroring map keeps fronts in front. Normals get unit length.
Mesh placed(const Mesh& mesh, const Affine& toWorld, Dropped& dropped);

} // namespace wellstrat::render
