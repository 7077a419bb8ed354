// SPDX-License-Identifier: Apache-2.0
//
// From the space of a mesh into the world.

#include "placing.h"
#include "../color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace wellstrat::render {
namespace {

constexpr uint32_t kUnused = ~uint32_t{0};

/// Farther out, the squares of areas exceed the largest float.
constexpr float kLargestCoordinate = 1e9f;

bool isNear(Float3 p) {
    return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
           std::abs(p.z) <= kLargestCoordinate;
}

Float2 finiteOrZero(Float2 uv) {
    return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : Float2(0, 0);
}

VertexColor inRange(const VertexColor& c) { return {clamp01(c.color), clamp01(c.opacity)}; }

class Placer {
public:
    Placer(const Mesh& source, const Affine& toWorld, Dropped& dropped)
        : source_(source), toWorld_(toWorld), dropped_(dropped),
          newIndices_(source.positions.size(), kUnused) {}

    Mesh place() {
        mesh_.material = source_.material;
        mesh_.triangles.reserve(source_.triangles.size());
        for (const auto& triangle : source_.triangles) add(triangle);
        return std::move(mesh_);
    }

private:
    using Corners = std::array<uint32_t, 3>;

    void add(Corners corners) {
        if (toWorld_.isMirroring()) std::swap(corners[1], corners[2]);
        std::array<Float3, 3> at{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (corners[i] >= source_.positions.size()) {
                ++dropped_.notFinite;
                return;
            }
            at[i] = toWorld_.point(source_.positions[corners[i]]);
        }
        if (!std::all_of(at.begin(), at.end(), isNear)) {
            ++(std::all_of(at.begin(), at.end(), isFinite) ? dropped_.tooFar : dropped_.notFinite);
            return;
        }
        Float3 normal = Cross(at[1] - at[0], at[2] - at[0]);
        if (!(normal.LengthSq() >= std::numeric_limits<float>::min())) {
            ++dropped_.degenerate;
            return;
        }
        normal.Normalize();
        Corners triangle{};
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = addVertex(corners[i], at[i], normal);
        mesh_.triangles.push_back(triangle);
    }

    /// The index of a vertex in the new mesh.
    uint32_t addVertex(uint32_t i, Float3 position, Float3 faceNormal) {
        uint32_t& index = newIndices_[i];
        if (index != kUnused) return index;
        index = static_cast<uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(position);
        if (!source_.normals.empty()) mesh_.normals.push_back(normalOf(i, faceNormal));
        if (!source_.uvs.empty()) mesh_.uvs.push_back(finiteOrZero(source_.uvs[i]));
        if (!source_.secondUvs.empty())
            mesh_.secondUvs.push_back(finiteOrZero(source_.secondUvs[i]));
        if (!source_.colors.empty()) mesh_.colors.push_back(inRange(source_.colors[i]));
        return index;
    }

    Float3 normalOf(uint32_t i, Float3 faceNormal) const {
        Float3 normal = toWorld_.normal(source_.normals[i]);
        normal.Normalize();
        return std::abs(normal.LengthSq() - 1) < 1e-3f ? normal : faceNormal;
    }

    const Mesh& source_;
    const Affine& toWorld_;
    Dropped& dropped_;
    std::vector<uint32_t> newIndices_;
    Mesh mesh_;
};

} // namespace

std::vector<std::string> Dropped::texts() const {
    std::vector<std::string> texts;
    const auto add = [&](uint64_t count, const char* what) {
        if (count > 0) texts.push_back(fmt::format("{} {}", count, what));
    };
    add(notFinite, "triangles with a corner that is no number");
    add(tooFar, "triangles with a corner beyond 1e9");
    add(degenerate, "triangles without area");
    add(otherFaces, "lines and points");
    return texts;
}

Mesh placed(const Mesh& mesh, const Affine& toWorld, Dropped& dropped) {
    return Placer(mesh, toWorld, dropped).place();
}

} // namespace wellstrat::render
