// SPDX-License-Identifier: Apache-2.0

#include "primitives.h"
#include "values.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace wellstrat::render {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

/// glTF 2.0 specification, section 3.7.2.1, "Overview" of geometry: which corners make a triangle,
/// counterclockwise as seen from its front.
Triangles trianglesOf(int mode, const std::vector<uint32_t>& corners) {
    Triangles triangles;
    const std::size_t count = corners.size();
    if (mode == TINYGLTF_MODE_TRIANGLES)
        for (std::size_t i = 0; i + 2 < count; i += 3)
            triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < count; ++i)
            triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        for (std::size_t i = 0; i + 2 < count; ++i)
            triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
    return triangles;
}

/// The points or lines of these corners, if the mode has such.
uint64_t otherFacesOf(int mode, uint64_t corners) {
    switch (mode) {
    case TINYGLTF_MODE_POINTS:
    case TINYGLTF_MODE_LINE_LOOP: return corners;
    case TINYGLTF_MODE_LINE: return corners / 2;
    case TINYGLTF_MODE_LINE_STRIP: return corners > 0 ? corners - 1 : 0;
    default: return 0;
    }
}

template <typename T, typename Convert>
std::vector<T> converted(const std::optional<Numbers>& numbers, Convert convert) {
    std::vector<T> values;
    if (!numbers) return values;
    values.reserve(numbers->count());
    for (std::size_t i = 0; i < numbers->count(); ++i) values.push_back(convert(*numbers, i));
    return values;
}

std::vector<Float3> float3s(const std::optional<Numbers>& numbers) {
    return converted<Float3>(numbers, [](const Numbers& n, std::size_t i) { return n.float3(i); });
}

std::vector<Float2> float2s(const std::optional<Numbers>& numbers) {
    return converted<Float2>(numbers, [](const Numbers& n, std::size_t i) { return n.float2(i); });
}

} // namespace

GltfPrimitive::GltfPrimitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                             Notes& notes)
    : document_(document), primitive_(primitive), notes_(notes) {
    if (kHasDraco && find(primitive.extensions, kDracoExtension))
        draco_ = decodeDraco(document, primitive);
    const bool has = (draco_ && draco_->attributes.count("POSITION") > 0) ||
                     primitive.attributes.count("POSITION") > 0;
    if (!has) {
        notes_.add("Primitives without positions are left out.");
        return;
    }
    positions_ = draco_ && draco_->attributes.count("POSITION") > 0
                     ? draco_->attributes.at("POSITION")
                     : readNumbers(document, primitive.attributes.at("POSITION"));
}

std::optional<Numbers> GltfPrimitive::attribute(const std::string& name) const {
    std::optional<Numbers> numbers;
    if (draco_) {
        const auto found = draco_->attributes.find(name);
        if (found != draco_->attributes.end()) numbers = found->second;
    }
    const auto found = primitive_.attributes.find(name);
    if (!numbers && found != primitive_.attributes.end())
        numbers = readNumbers(document_, found->second);
    if (!numbers || numbers->count() == vertexCount()) return numbers;
    notes_.add(fmt::format("{} is left out where it has not as many elements as POSITION.", name));
    return {};
}

std::optional<Numbers> GltfPrimitive::withTargets(const std::string& name,
                                                  const std::vector<double>& weights) const {
    std::optional<Numbers> numbers = name == "POSITION" ? positions_ : attribute(name);
    if (!numbers) return numbers;
    const std::size_t targets = std::min(weights.size(), primitive_.targets.size());
    for (std::size_t t = 0; t < targets; ++t) {
        const auto found = primitive_.targets[t].find(name);
        const auto weight = static_cast<float>(weights[t]);
        if (weight == 0.0f || found == primitive_.targets[t].end()) continue;
        const Numbers target = readNumbers(document_, found->second);
        if (target.values.size() != numbers->values.size()) {
            notes_.add(
                "Morph targets are left out where they have not as many elements as POSITION.");
            continue;
        }
        for (std::size_t i = 0; i < target.values.size(); ++i)
            numbers->values[i] += weight * target.values[i];
    }
    return numbers;
}

Mesh GltfPrimitive::mesh(const std::vector<double>& weights, std::array<int, 2> uvSets,
                         Dropped& dropped) const {
    Mesh mesh;
    if (!positions_) return mesh;
    std::vector<uint32_t> corners;
    if (draco_) {
        corners = draco_->corners;
    } else if (primitive_.indices >= 0) {
        corners = readIndices(document_, primitive_.indices);
    } else {
        corners.resize(vertexCount());
        std::iota(corners.begin(), corners.end(), 0u);
    }
    // Draco's are triangles whatever they were.
    const int mode = draco_ ? TINYGLTF_MODE_TRIANGLES : primitive_.mode;
    mesh.triangles = trianglesOf(mode, corners);
    dropped.otherFaces += otherFacesOf(mode, corners.size());
    if (mesh.triangles.empty()) return mesh;

    mesh.positions = float3s(withTargets("POSITION", weights));
    mesh.normals = float3s(withTargets("NORMAL", weights));
    const auto uvs = [&](int set) {
        if (set < 0) return std::vector<Float2>();
        return float2s(withTargets(fmt::format("TEXCOORD_{}", set), weights));
    };
    mesh.uvs = uvs(uvSets[0]);
    mesh.secondUvs = uvs(uvSets[1]);
    mesh.colors = converted<VertexColor>(
        withTargets("COLOR_0", weights), [](const Numbers& numbers, std::size_t i) {
            const auto color = numbers.element<4>(i, 1); // alpha may be missing
            return VertexColor{{color[0], color[1], color[2]}, color[3]};
        });
    return mesh;
}

} // namespace wellstrat::render
