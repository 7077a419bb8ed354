// SPDX-License-Identifier: Apache-2.0

#include "ply_scene.h"
#include "../file_textures.h"
#include "../files.h"
#include "../polygons.h"
#include "../scene_builder.h"
#include "ply_file.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The origin of PLY is the lower left corner, that of textures here the upper left one.
std::vector<Float2> fromUpperLeft(std::vector<Float2> uvs) {
    for (Float2& uv : uvs) uv.y = 1 - uv.y;
    return uvs;
}

/// Gives each corner a vertex of its own.
void unshareVertices(PlyFile& file) {
    const auto spread = [&](auto& values, auto missing) {
        if (values.empty()) return;
        auto old = std::exchange(values, {});
        values.reserve(file.corners.size());
        for (const uint32_t corner : file.corners)
            values.push_back(corner == kNoPlyIndex ? missing : old[corner]);
    };
    spread(file.normals, Float3(kNaN));
    spread(file.colors, Float3(1.0f));
    spread(file.positions, Float3(kNaN));
    for (std::size_t i = 0; i < file.corners.size(); ++i)
        file.corners[i] = static_cast<uint32_t>(i);
    file.uvs = std::exchange(file.cornerUvs, {});
}

std::vector<std::array<uint32_t, 3>> trianglesOf(const PlyFile& file) {
    std::vector<std::array<uint32_t, 3>> triangles;
    triangles.reserve(file.corners.size() - 2 * file.faceEnds.size());
    std::vector<Float3> positions; // of the corners of a face
    std::size_t begin = 0;
    for (const uint64_t end : file.faceEnds) {
        positions.clear();
        for (std::size_t i = begin; i < end; ++i)
            positions.push_back(file.corners[i] == kNoPlyIndex ? Float3(kNaN)
                                                               : file.positions[file.corners[i]]);
        const std::size_t first = triangles.size();
        appendTriangles(positions, triangles);
        for (std::size_t i = first; i < triangles.size(); ++i)
            for (uint32_t& corner : triangles[i]) corner = file.corners[begin + corner];
        begin = end;
    }
    return triangles;
}

Material materialOf(const PlyFile& file, SceneBuilder& builder) {
    Material material;
    material.specularF0 = 0;
    material.doubleSided = true;
    if (!file.texture.empty() && !file.uvs.empty())
        material.baseColorTexture =
            FileTextures(builder.files, builder.notes).get(file.texture, TextureUse::reflectance);
    if (!file.colors.empty() || material.baseColorTexture) material.baseColor = Float3(1.0f);
    return material;
}

} // namespace

Scene importPly(const std::string& path, uint64_t mostTriangles) {
    SceneBuilder builder(path, mostTriangles);
    PlyFile file = parsePly(contentOf(path));
    builder.expect(file.corners.size() - 2 * file.faceEnds.size());
    if (!file.cornerUvs.empty()) unshareVertices(file);
    builder.scene.materials.push_back(materialOf(file, builder));

    Mesh mesh;
    mesh.triangles = trianglesOf(file);
    mesh.positions = std::move(file.positions);
    mesh.normals = std::move(file.normals);
    mesh.uvs = fromUpperLeft(std::move(file.uvs));
    for (const Float3 color : file.colors) mesh.colors.push_back({color, 1});
    builder.add(mesh, {});
    builder.dropped.otherFaces += file.otherElements;
    if (file.hasFaceColors) builder.notes.add("Colors of faces are left out.");
    return builder.finish();
}

} // namespace wellstrat::render
