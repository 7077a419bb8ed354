// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's meshes to ours.

#include "meshes.h"
#include "conversions.h"

#include <algorithm>
#include <iterator>

namespace wellstrat::render {

Mesh importMesh(const aiMesh& source, unsigned uvSet, Dropped& dropped) {
    Mesh mesh;
    mesh.triangles.reserve(source.mNumFaces);
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices == 3)
            mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        else
            ++dropped.otherFaces;
    }
    const auto fill = [&](const aiVector3D* from, auto& to, auto convert) {
        if (from) std::transform(from, from + source.mNumVertices, std::back_inserter(to), convert);
    };
    fill(source.mVertices, mesh.positions, toFloat3);
    fill(source.mNormals, mesh.normals, toFloat3);
    // Assimp's origin is the lower left corner, that of textures here the upper left one.
    fill(source.mTextureCoords[std::min(uvSet, AI_MAX_NUMBER_OF_TEXTURECOORDS - 1u)], mesh.uvs,
         [](const aiVector3D& uv) { return Float2(uv.x, 1 - uv.y); });
    return mesh;
}

} // namespace wellstrat::render
