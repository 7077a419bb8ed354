// SPDX-License-Identifier: Apache-2.0
//
// glTF files with compressed meshes, by the encoders of the libraries.

#include "gltf_files.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <gtest/gtest.h>

namespace wellstrat::render {
namespace {

using nlohmann::json;

/// Makes buffer view `view` of `quadGltf` one that is compressed, in a buffer that has no data of
/// its own.
void compress(json& gltf, std::size_t view, const std::string& stream, std::size_t stride,
              std::size_t count, const char* mode, const char* filter = "NONE") {
    const std::size_t compressed = addView(gltf, stream);
    gltf["bufferViews"][view] = {{"buffer", 0},
                                 {"byteLength", stride * count},
                                 {"extensions",
                                  {{"EXT_meshopt_compression",
                                    {{"buffer", gltf["bufferViews"][compressed]["buffer"]},
                                     {"byteLength", stream.size()},
                                     {"byteStride", stride},
                                     {"count", count},
                                     {"mode", mode},
                                     {"filter", filter}}}}}};
}

std::string encodedVertices(const void* vertices, std::size_t count, std::size_t stride) {
    std::string stream(meshopt_encodeVertexBufferBound(count, stride), '\0');
    auto* const bytes = reinterpret_cast<unsigned char*>(stream.data());
    stream.resize(meshopt_encodeVertexBuffer(bytes, stream.size(), vertices, count, stride));
    return stream;
}

TEST(GltfCompressed, Meshopt) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] = json::array({"EXT_meshopt_compression"});
    const std::string quad = quadBuffer();
    compress(gltf, 0, encodedVertices(quad.data(), 4, 12), 12, 4, "ATTRIBUTES");

    // Normals, four bytes each: octahedral, with z = 127 for one.
    const float normals[16] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    int8_t octahedral[16];
    meshopt_encodeFilterOct(octahedral, 4, 4, 8, normals);
    compress(gltf, 1, encodedVertices(octahedral, 4, 4), 4, 4, "ATTRIBUTES", "OCTAHEDRAL");
    gltf["bufferViews"][1]["byteStride"] = 4;
    gltf["accessors"][1]["componentType"] = 5120;
    gltf["accessors"][1]["normalized"] = true;

    const unsigned corners[6] = {0, 1, 2, 0, 2, 3};
    std::string stream(meshopt_encodeIndexBufferBound(6, 4), '\0');
    stream.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(stream.data()),
                                            stream.size(), corners, 6));
    compress(gltf, 3, stream, 2, 6, "TRIANGLES");
    // No file, as only those need who cannot decompress.
    gltf["buffers"].push_back(gltf["buffers"][0]);
    gltf["bufferViews"][2]["buffer"] = gltf["buffers"].size() - 1;
    gltf["buffers"][0] = {{"byteLength", 140}};

    const Mesh mesh = readScene(writeGltf(folder, gltf)).meshes.at(0);
    ASSERT_EQ(mesh.positions.size(), 4u);
    expectNear(mesh.positions[2], {1, 1, 0}, 0);
    expectNear(mesh.positions[3], {0, 1, 0}, 0);
    expectNear(mesh.normals[1], {0, 0, 1}, 0);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.uvs[0].y, 1.0f);
}

/// The square of `quadGltf`, and the numbers of its attributes.
struct DracoStream {
    std::string bytes;
    int position, normal, uv;
};

DracoStream dracoQuad() {
    const draco::Vector3f corner[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const draco::Vector2f uv[4] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const draco::Vector3f normal(0, 0, 1);
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    DracoStream stream;
    stream.position =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    stream.normal = builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    stream.uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    const int corners[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (int i = 0; i < 2; ++i) {
        const auto& [a, b, c] = corners[i];
        const draco::FaceIndex face(static_cast<uint32_t>(i));
        builder.SetAttributeValuesForFace(stream.position, face, corner[a].data(), corner[b].data(),
                                          corner[c].data());
        builder.SetAttributeValuesForFace(stream.normal, face, normal.data(), normal.data(),
                                          normal.data());
        builder.SetAttributeValuesForFace(stream.uv, face, uv[a].data(), uv[b].data(),
                                          uv[c].data());
    }
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    stream.bytes.assign(buffer.data(), buffer.size());
    return stream;
}

/// As the extension wants it: accessors without buffer views.
TEST(GltfCompressed, Draco) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] =
        json::array({"KHR_draco_mesh_compression"});
    for (json& accessor : gltf["accessors"]) accessor.erase("bufferView");
    gltf["bufferViews"] = json::array();
    gltf["buffers"] = json::array();
    const DracoStream stream = dracoQuad();
    primitiveOf(gltf)["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", addView(gltf, stream.bytes)},
        {"attributes",
         {{"POSITION", stream.position}, {"NORMAL", stream.normal}, {"TEXCOORD_0", stream.uv}}}};
    const Mesh mesh = readScene(writeGltf(folder, gltf)).meshes.at(0);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    ASSERT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.uvs.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        expectNear(mesh.normals[i], {0, 0, 1}, 1e-3f);
        EXPECT_NEAR(mesh.uvs[i].x, mesh.positions[i].x, 1e-3f);
        EXPECT_NEAR(mesh.uvs[i].y, 1 - mesh.positions[i].y, 1e-3f);
    }
}

} // namespace
} // namespace wellstrat::render
