// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's meshes to ours.

#include "meshes.h"
#include "conversions.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr uint32_t kUnused = ~uint32_t{0};

/// Farther out, the squares of areas exceed the largest float.
constexpr float kLargestCoordinate = 1e9f;

bool isNear(Float3 p) {
    return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
           std::abs(p.z) <= kLargestCoordinate;
}

class MeshReader {
public:
    MeshReader(const aiMesh& source, const aiMatrix4x4& toWorld, unsigned uvSet, Dropped& dropped)
        : source_(source), toWorld_(toWorld), uvs_(source.mTextureCoords[uvSet]), dropped_(dropped),
          newIndices_(source.mNumVertices, kUnused) {
        aiMatrix3x3 linear(toWorld);
        isMirrored_ = linear.Determinant() < 0;
        normalToWorld_ = linear.Inverse().Transpose();
    }

    Mesh read() {
        mesh_.triangles.reserve(source_.mNumFaces);
        for (unsigned i = 0; i < source_.mNumFaces; ++i) addFace(source_.mFaces[i]);
        return std::move(mesh_);
    }

private:
    void addFace(const aiFace& face) {
        if (face.mNumIndices != 3) {
            ++dropped_.otherFaces;
            return;
        }
        std::array<uint32_t, 3> corners{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
        if (isMirrored_) std::swap(corners[1], corners[2]);
        std::array<Float3, 3> at{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (corners[i] >= source_.mNumVertices) {
                ++dropped_.notFinite;
                return;
            }
            at[i] = toFloat3(toWorld_ * source_.mVertices[corners[i]]);
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
        std::array<uint32_t, 3> triangle{};
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = addVertex(corners[i], at[i], normal);
        mesh_.triangles.push_back(triangle);
    }

    /// The index of a vertex in the new mesh.
    uint32_t addVertex(uint32_t i, Float3 position, Float3 faceNormal) {
        uint32_t& index = newIndices_[i];
        if (index != kUnused) return index;
        index = static_cast<uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(position);
        if (source_.mNormals) mesh_.normals.push_back(normalOf(i, faceNormal));
        if (uvs_) mesh_.uvs.push_back(uvOf(i));
        return index;
    }

    Float3 normalOf(uint32_t i, Float3 faceNormal) const {
        Float3 normal = toFloat3(normalToWorld_ * source_.mNormals[i]);
        normal.Normalize();
        return std::abs(normal.LengthSq() - 1) < 1e-3f ? normal : faceNormal;
    }

    /// Assimp's origin is the lower left corner, that of textures here the upper left one.
    Float2 uvOf(uint32_t i) const {
        const aiVector3D& uv = uvs_[i];
        const Float3 flipped(uv.x, 1 - uv.y, 0);
        return isFinite(flipped) ? Float2(flipped.x, flipped.y) : Float2(0, 0);
    }

    const aiMesh& source_;
    const aiMatrix4x4& toWorld_;
    const aiVector3D* uvs_;
    Dropped& dropped_;
    std::vector<uint32_t> newIndices_;
    aiMatrix3x3 normalToWorld_;
    bool isMirrored_;
    Mesh mesh_;
};

} // namespace

Mesh importMesh(const aiMesh& source, const aiMatrix4x4& toWorld, unsigned uvSet,
                Dropped& dropped) {
    return MeshReader(source, toWorld, std::min(uvSet, AI_MAX_NUMBER_OF_TEXTURECOORDS - 1u),
                      dropped)
        .read();
}

} // namespace wellstrat::render
