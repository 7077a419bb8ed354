// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's meshes to ours.

#pragma once

#include "../scene.h"
#include "placing.h"

#include <assimp/mesh.h>

namespace wellstrat::render {

/// The triangles of `source`, in its own space and as they are: `placed` takes out what cannot be
/// rendered. Other faces are counted. `uvSet` is the set of texture coordinates to take, if the
/// mesh has it. The material is left at 0.
Mesh importMesh(const aiMesh& source, unsigned uvSet, Dropped& dropped);

} // namespace wellstrat::render
