// SPDX-License-Identifier: Apache-2.0
//
// Meshes that bones move.

#pragma once

#include "../../scene.h"
#include "nodes.h"
#include "primitives.h"

#include <vector>

namespace wellstrat::render {

/// Moves a mesh of this primitive, which is in its own space, to where the joints of the skin put
/// it in the world, as their nodes stand in the file: the joints move it, and not its own node.
/// False, and nothing is done, if its vertices belong to no joints. Throws std::runtime_error for
/// joints that do not exist.
bool pose(Mesh& mesh, const GltfDocument& document, const GltfPrimitive& primitive, int skin,
          const std::vector<Affine>& nodesToWorld);

} // namespace wellstrat::render
