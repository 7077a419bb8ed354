// SPDX-License-Identifier: Apache-2.0
//
// The nodes of a glTF file: what is where.

#pragma once

#include "../affine.h"
#include "../notes.h"
#include "document.h"

#include <tiny_gltf.h>

#include <vector>

namespace wellstrat::render {

/// A mesh, light or camera, by its number, where a node puts it.
struct GltfInstance {
    int number;
    Affine toWorld;
    const tinygltf::Node* node;
};

/// All instances of a scene, in the order of its nodes.
struct GltfNodes {
    std::vector<GltfInstance> meshes, lights, cameras;
    std::vector<Affine> toWorld; ///< of each node of the file; of those not in the scene, none
};

/// Walks the default scene, or the first, with a note if there are more; all nodes if there is
/// none. What KHR_node_visibility hides is not in it, but for cameras; what
/// EXT_mesh_gpu_instancing repeats is in it as often. Throws std::runtime_error for nodes that do
/// not exist, or with more than one way to them, and for more than `mostInstances` of meshes.
GltfNodes readNodes(const GltfDocument& document, uint64_t mostInstances, Notes& notes);

} // namespace wellstrat::render
