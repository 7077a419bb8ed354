// SPDX-License-Identifier: Apache-2.0

#include "skins.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

namespace wellstrat::render {
namespace {

/// From the space of the mesh to the world, for each joint.
std::vector<Affine> jointsOf(const GltfDocument& document, const tinygltf::Skin& skin,
                             const std::vector<Affine>& nodesToWorld) {
    std::optional<Numbers> inverses;
    if (skin.inverseBindMatrices >= 0) inverses = readNumbers(document, skin.inverseBindMatrices);
    if (inverses && (inverses->components != 16 || inverses->count() < skin.joints.size()))
        throw std::runtime_error("a skin has not as many inverse bind matrices as joints");
    std::vector<Affine> joints;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        Affine toJoint;
        if (inverses) {
            const auto m = inverses->element<16>(i);
            toJoint = {
                {m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
        }
        joints.push_back(at(nodesToWorld, skin.joints[i], "node") * toJoint);
    }
    return joints;
}

void add(Affine& sum, const Affine& joint, float weight) {
    sum.x += joint.x * weight;
    sum.y += joint.y * weight;
    sum.z += joint.z * weight;
    sum.origin += joint.origin * weight;
}

/// Four joints a vertex, and what each counts.
struct Influences {
    Numbers joints, weights;
};

std::vector<Influences> influencesOf(const GltfPrimitive& primitive) {
    std::vector<Influences> result;
    for (int set = 0;; ++set) {
        auto joints = primitive.attribute(fmt::format("JOINTS_{}", set));
        auto weights = primitive.attribute(fmt::format("WEIGHTS_{}", set));
        if (!joints || !weights) return result;
        result.push_back({std::move(*joints), std::move(*weights)});
    }
}

} // namespace

bool pose(Mesh& mesh, const GltfDocument& document, const GltfPrimitive& primitive, int skin,
          const std::vector<Affine>& nodesToWorld) {
    const std::vector<Influences> influences = influencesOf(primitive);
    if (influences.empty()) return false;
    const std::vector<Affine> joints =
        jointsOf(document, at(document.model().skins, skin, "skin"), nodesToWorld);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Affine toWorld{Float3(0.0f), Float3(0.0f), Float3(0.0f), Float3(0.0f)};
        for (const Influences& four : influences) {
            const auto numbers = four.joints.element<4>(i), weights = four.weights.element<4>(i);
            for (std::size_t j = 0; j < 4; ++j)
                if (weights[j] != 0.0f)
                    add(toWorld, at(joints, static_cast<int>(numbers[j]), "joint"), weights[j]);
        }
        mesh.positions[i] = toWorld.point(mesh.positions[i]);
        if (!mesh.normals.empty()) mesh.normals[i] = toWorld.normal(mesh.normals[i]);
    }
    return true;
}

} // namespace wellstrat::render
