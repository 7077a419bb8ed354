// SPDX-License-Identifier: Apache-2.0
//
// From the primitives of glTF to meshes.

#pragma once

#include "../../scene.h"
#include "../placing.h"
#include "accessors.h"
#include "draco.h"

#include <tiny_gltf.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::render {

/// A primitive, whose numbers are in accessors or compressed.
class GltfPrimitive {
public:
    GltfPrimitive(const GltfDocument& document, const tinygltf::Primitive& primitive, Notes& notes);

    /// How many vertices it has; 0 without positions.
    std::size_t vertexCount() const { return positions_ ? positions_->count() : 0; }

    /// The numbers of an attribute, as many as there are vertices. None if it is not there, or,
    /// with a note, of another count.
    std::optional<Numbers> attribute(const std::string& name) const;

    /// The mesh in its own space, changed by its morph targets, each as much as its weight says; a
    /// target without weight counts not. `uvSets` are the sets of texture coordinates to take, -1
    /// for none. Points and lines are counted in `dropped`. Corners of triangles may be any
    /// numbers.
    Mesh mesh(const std::vector<double>& weights, std::array<int, 2> uvSets,
              Dropped& dropped) const;

private:
    std::optional<Numbers> withTargets(const std::string& name,
                                       const std::vector<double>& weights) const;

    const GltfDocument& document_;
    const tinygltf::Primitive& primitive_;
    Notes& notes_;
    std::optional<DracoPrimitive> draco_;
    std::optional<Numbers> positions_;
};

} // namespace wellstrat::render
