// SPDX-License-Identifier: Apache-2.0

#include "nodes.h"
#include "accessors.h"
#include "values.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

using Quaternion = std::array<float, 4>; // x, y, z, w

/// First scaled, then turned, then moved.
Affine placeOf(Float3 translation, Quaternion q, Float3 scale) {
    const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const float inverse = length > 0.0f ? 1.0f / length : 0.0f;
    const float x = q[0] * inverse, y = q[1] * inverse, z = q[2] * inverse, w = q[3] * inverse;
    return {Float3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)) * scale.x,
            Float3(2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)) * scale.y,
            Float3(2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)) * scale.z,
            translation};
}

Float3 float3At(const std::vector<double>& numbers, std::size_t first) {
    return {static_cast<float>(numbers[first]), static_cast<float>(numbers[first + 1]),
            static_cast<float>(numbers[first + 2])};
}

Affine placeOf(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) // by columns
        return {float3At(node.matrix, 0), float3At(node.matrix, 4), float3At(node.matrix, 8),
                float3At(node.matrix, 12)};
    Quaternion rotation{0, 0, 0, 1};
    if (node.rotation.size() == 4)
        for (std::size_t i = 0; i < 4; ++i) rotation[i] = static_cast<float>(node.rotation[i]);
    const bool moves = node.translation.size() == 3, scales = node.scale.size() == 3;
    return placeOf(moves ? float3At(node.translation, 0) : Float3(0.0f), rotation,
                   scales ? float3At(node.scale, 0) : Float3(1.0f));
}

/// The places of EXT_mesh_gpu_instancing, within the node.
std::vector<Affine> placesOf(const GltfDocument& document, const tinygltf::Value& extension) {
    const tinygltf::Value* const attributes = find(extension, "attributes");
    const auto numbersOf = [&](const char* name) -> std::optional<Numbers> {
        if (!attributes || indexOf(*attributes, name) < 0) return {};
        return readNumbers(document, indexOf(*attributes, name));
    };
    const auto translations = numbersOf("TRANSLATION"), rotations = numbersOf("ROTATION"),
               scales = numbersOf("SCALE");
    std::optional<std::size_t> count;
    for (const auto* numbers : {&translations, &rotations, &scales}) {
        if (!*numbers) continue;
        if (count && *count != (*numbers)->count())
            throw std::runtime_error(
                "EXT_mesh_gpu_instancing: its attributes have different counts");
        count = (*numbers)->count();
    }
    std::vector<Affine> places;
    for (std::size_t i = 0; i < count.value_or(0); ++i)
        places.push_back(placeOf(translations ? translations->float3(i) : Float3(0.0f),
                                 rotations ? rotations->element<4>(i) : Quaternion{0, 0, 0, 1},
                                 scales ? scales->float3(i) : Float3(1.0f)));
    return places;
}

bool isHidden(const tinygltf::Node& node) {
    const tinygltf::Value* const extension = find(node.extensions, "KHR_node_visibility");
    const tinygltf::Value* const visible = extension ? find(*extension, "visible") : nullptr;
    return visible && visible->IsBool() && !visible->Get<bool>();
}

/// Nodes that are no other's child.
std::vector<int> roots(const tinygltf::Model& model) {
    std::vector<bool> isChild(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < isChild.size())
                isChild[static_cast<std::size_t>(child)] = true;
    std::vector<int> result;
    for (std::size_t i = 0; i < isChild.size(); ++i)
        if (!isChild[i]) result.push_back(static_cast<int>(i));
    return result;
}

std::vector<int> firstNodes(const tinygltf::Model& model, Notes& notes) {
    if (model.scenes.empty()) return roots(model);
    if (model.scenes.size() > 1)
        notes.add(fmt::format("There are {} scenes: {} is rendered.", model.scenes.size(),
                              model.defaultScene < 0 ? "the first" : "the file's default"));
    return at(model.scenes, std::max(model.defaultScene, 0), "scene").nodes;
}

class Walk {
public:
    Walk(const GltfDocument& document, uint64_t mostInstances)
        : document_(document), mostInstances_(mostInstances),
          isVisited_(document.model().nodes.size()) {
        result_.toWorld.resize(isVisited_.size());
    }

    /// A loop, so that the depth of the tree takes no stack.
    GltfNodes from(const std::vector<int>& first) {
        std::vector<Open> open;
        const auto push = [&](const std::vector<int>& nodes, const Affine& toWorld, bool hidden) {
            for (auto i = nodes.rbegin(); i != nodes.rend(); ++i)
                open.push_back({*i, toWorld, hidden});
        };
        push(first, {}, false);
        while (!open.empty()) {
            const Open next = open.back();
            open.pop_back();
            const tinygltf::Node& node = at(document_.model().nodes, next.node, "node");
            const auto number = static_cast<std::size_t>(next.node);
            if (isVisited_[number])
                throw std::runtime_error(
                    fmt::format("there is more than one way to node {}", number));
            isVisited_[number] = true;
            const Affine toWorld = next.parentToWorld * placeOf(node);
            const bool hidden = next.isHidden || isHidden(node);
            result_.toWorld[number] = toWorld;
            visit(node, toWorld, hidden);
            push(node.children, toWorld, hidden);
        }
        return std::move(result_);
    }

private:
    struct Open {
        int node;
        Affine parentToWorld;
        bool isHidden;
    };

    void visit(const tinygltf::Node& node, const Affine& toWorld, bool hidden) {
        if (node.camera >= 0) result_.cameras.push_back({node.camera, toWorld, &node});
        if (hidden) return;
        if (const auto* const light = find(node.extensions, "KHR_lights_punctual"))
            result_.lights.push_back({indexOf(*light, "light"), toWorld, &node});
        if (node.mesh < 0) return;
        const auto* const instancing = find(node.extensions, "EXT_mesh_gpu_instancing");
        if (!instancing) return addMesh(node, toWorld);
        for (const Affine& place : placesOf(document_, *instancing)) addMesh(node, toWorld * place);
    }

    void addMesh(const tinygltf::Node& node, const Affine& toWorld) {
        if (result_.meshes.size() >= mostInstances_)
            throw std::runtime_error(
                fmt::format("has more than {} meshes, all instances counted", mostInstances_));
        result_.meshes.push_back({node.mesh, toWorld, &node});
    }

    const GltfDocument& document_;
    const uint64_t mostInstances_;
    std::vector<bool> isVisited_;
    GltfNodes result_;
};

} // namespace

GltfNodes readNodes(const GltfDocument& document, uint64_t mostInstances, Notes& notes) {
    return Walk(document, mostInstances).from(firstNodes(document.model(), notes));
}

} // namespace wellstrat::render
