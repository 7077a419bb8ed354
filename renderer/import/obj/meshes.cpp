// SPDX-License-Identifier: Apache-2.0

#include "meshes.h"
#include "../../color.h"
#include "../polygons.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace wellstrat::render {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class MeshMaker {
public:
    explicit MeshMaker(const ObjFile& file) : file_(file), first_(file.positions.size(), kNone) {}

    std::vector<Mesh> make() {
        std::size_t begin = 0;
        for (const ObjFace& face : file_.faces) {
            addFace(begin, face.end, face.material);
            begin = face.end;
        }
        return std::move(meshes_);
    }

private:
    static constexpr uint32_t kNone = kNoObjIndex;

    /// A corner that meshes have. Those at one position are a list.
    struct Vertex {
        uint32_t mesh, uv, normal;
        uint32_t index; ///< in the mesh
        uint32_t next;
    };

    void addFace(std::size_t begin, std::size_t end, uint32_t material) {
        bool hasNormals = true;
        positions_.clear();
        for (std::size_t i = begin; i < end; ++i) {
            const ObjCorner& corner = file_.corners[i];
            hasNormals = hasNormals && corner.normal != kNone;
            positions_.push_back(corner.position == kNone ? Float3(kNaN)
                                                          : file_.positions[corner.position]);
        }
        triangles_.clear();
        appendTriangles(positions_, triangles_);
        const uint32_t number = meshFor(material, hasNormals);
        for (auto& triangle : triangles_) {
            for (uint32_t& corner : triangle)
                corner = vertex(number, file_.corners[begin + corner], hasNormals);
            meshes_[number].triangles.push_back(triangle);
        }
    }

    uint32_t meshFor(uint32_t material, bool hasNormals) {
        const auto next = static_cast<uint32_t>(meshes_.size());
        const auto [known, isNew] = numbers_.try_emplace({material, hasNormals}, next);
        if (isNew) meshes_.emplace_back().material = material;
        return known->second;
    }

    /// The index of a corner in a mesh; one that no mesh has if it has no position.
    uint32_t vertex(uint32_t number, const ObjCorner& corner, bool hasNormals) {
        if (corner.position == kNone) return kNone;
        const uint32_t normal = hasNormals ? corner.normal : kNone;
        for (uint32_t i = first_[corner.position]; i != kNone; i = vertices_[i].next) {
            const Vertex& known = vertices_[i];
            if (known.mesh == number && known.uv == corner.uv && known.normal == normal)
                return known.index;
        }
        const auto index = static_cast<uint32_t>(meshes_[number].positions.size());
        const auto head = static_cast<uint32_t>(vertices_.size());
        vertices_.push_back({number, corner.uv, normal, index, first_[corner.position]});
        first_[corner.position] = head;
        append(meshes_[number], corner, hasNormals);
        return index;
    }

    void append(Mesh& mesh, const ObjCorner& corner, bool hasNormals) const {
        mesh.positions.push_back(file_.positions[corner.position]);
        if (hasNormals) mesh.normals.push_back(file_.normals[corner.normal]);
        // The origin of OBJ is the lower left corner, that of textures here the upper left one.
        if (!file_.uvs.empty()) {
            const Float2 uv = corner.uv == kNone ? Float2(0, 1) : file_.uvs[corner.uv];
            mesh.uvs.emplace_back(uv.x, 1 - uv.y);
        }
        if (!file_.colors.empty())
            mesh.colors.push_back({linearFromSrgb(file_.colors[corner.position]), 1});
    }

    const ObjFile& file_;
    std::vector<Mesh> meshes_;
    std::map<std::pair<uint32_t, bool>, uint32_t> numbers_; ///< of meshes
    std::vector<uint32_t> first_;                           ///< vertex of each position
    std::vector<Vertex> vertices_;
    std::vector<Float3> positions_; ///< of the corners of a face
    std::vector<std::array<uint32_t, 3>> triangles_;
};

} // namespace

std::vector<Mesh> meshesOf(const ObjFile& file) { return MeshMaker(file).make(); }

} // namespace wellstrat::render
