// SPDX-License-Identifier: Apache-2.0
//
// Meshes of glTF files: numbers of all types, primitives of all modes, morph targets, skins,
// compression.

#include "gltf_files.h"
#include "renderer/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wellstrat::render {
namespace {

using nlohmann::json;

Scene sceneOf(const TempFolder& folder, const json& gltf) {
    return readScene(writeGltf(folder, gltf));
}

// glTF 2.0 specification, section 3.11: f = c / 127, at least -1, and so on.
TEST(GltfMesh, NormalizedIntegers) {
    const TempFolder folder;
    json gltf = quadGltf();
    auto& attributes = primitiveOf(gltf)["attributes"];
    attributes["POSITION"] = addAccessor<int16_t>(
        gltf, {-32768, 0, 0, 32767, 0, 0, 32767, 16384, 0, 0, 32767, 0}, "VEC3", 3, true);
    attributes["NORMAL"] =
        addAccessor<int8_t>(gltf, {0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127}, "VEC3", 3, true);
    attributes["TEXCOORD_0"] =
        addAccessor<uint16_t>(gltf, {0, 65535, 65535, 32768, 0, 0, 1, 2}, "VEC2", 2, true);
    const Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.positions[0], {-1, 0, 0}, 0);
    expectNear(mesh.positions[2], {1, 16384.0f / 32767, 0}, 1e-7f);
    expectNear(mesh.normals[0], {0, 0, 1}, 0);
    EXPECT_EQ(mesh.uvs[0].y, 1.0f);
    EXPECT_NEAR(mesh.uvs[1].y, 32768.0f / 65535, 1e-7f);
    EXPECT_NEAR(mesh.uvs[3].y, 2.0f / 65535, 1e-9f);
}

// KHR_mesh_quantization: integers that are no fractions, in units that the node scales.
TEST(GltfMesh, Quantization) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] = json::array({"KHR_mesh_quantization"});
    gltf["nodes"][0]["scale"] = {0.25, 0.5, 1};
    auto& attributes = primitiveOf(gltf)["attributes"];
    attributes["POSITION"] =
        addAccessor<uint8_t>(gltf, {0, 0, 0, 4, 0, 0, 4, 2, 0, 0, 2, 255}, "VEC3", 3);
    attributes["TEXCOORD_0"] = addAccessor<int16_t>(gltf, {0, 3, -7, 3, 1, 0, 0, 0}, "VEC2", 2);
    const Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.positions[2], {1, 1, 0});
    expectNear(mesh.positions[3], {0, 1, 255});
    EXPECT_EQ(mesh.uvs[1].x, -7.0f);
}

// Strides, as gltfpack writes them: each element begins at a multiple of four.
TEST(GltfMesh, Strides) {
    const TempFolder folder;
    json gltf = quadGltf();
    std::string bytes;
    append<uint16_t>(bytes, {0, 0, 0, 9, 1, 0, 0, 9, 1, 1, 0, 9, 0, 1, 0});
    const std::size_t view = addView(gltf, bytes);
    gltf["bufferViews"][view]["byteStride"] = 8;
    gltf["accessors"][0] = {
        {"bufferView", view}, {"componentType", 5123}, {"count", 4}, {"type", "VEC3"}};
    const Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.positions[2], {1, 1, 0}, 0);
    expectNear(mesh.positions[3], {0, 1, 0}, 0);
}

TEST(GltfMesh, SparseValues) {
    const TempFolder folder;
    json gltf = quadGltf();
    std::string places, values;
    append<uint16_t>(places, {1, 3});
    append<float>(values, {5, 0, 0, 0, 7, 0});
    gltf["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", addView(gltf, places)}, {"componentType", 5123}}},
        {"values", {{"bufferView", addView(gltf, values)}}}};
    const Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.positions[1], {5, 0, 0}, 0);
    expectNear(mesh.positions[2], {1, 1, 0}, 0);
    expectNear(mesh.positions[3], {0, 7, 0}, 0);
}

/// The corners of triangle i.
std::vector<Float3> cornersOf(const Mesh& mesh, std::size_t i) {
    std::vector<Float3> corners;
    for (const uint32_t corner : mesh.triangles.at(i)) corners.push_back(mesh.positions[corner]);
    return corners;
}

TEST(GltfMesh, StripsAndFans) {
    const TempFolder folder;
    json gltf = quadGltf();
    primitiveOf(gltf).erase("indices");
    primitiveOf(gltf)["mode"] = 6; // a fan round the square
    Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(cornersOf(mesh, 0), (std::vector<Float3>{{1, 0, 0}, {1, 1, 0}, {0, 0, 0}}));
    EXPECT_EQ(cornersOf(mesh, 1), (std::vector<Float3>{{1, 1, 0}, {0, 1, 0}, {0, 0, 0}}));

    primitiveOf(gltf)["mode"] = 5;
    primitiveOf(gltf)["indices"] = addAccessor<uint8_t>(gltf, {0, 1, 3, 2}, "SCALAR", 1);
    mesh = sceneOf(folder, gltf).meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(cornersOf(mesh, 0), (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(cornersOf(mesh, 1), (std::vector<Float3>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    for (uint32_t i = 0; i < 2; ++i) EXPECT_GT(triangleAt(mesh, i, 0).areaNormal().z, 0.0f);
}

TEST(GltfMesh, LinesAndPointsAreCounted) {
    const TempFolder folder;
    json gltf = quadGltf();
    json other = primitiveOf(gltf);
    other.erase("indices");
    for (const int mode : {0, 1, 2, 3}) {
        other["mode"] = mode;
        gltf["meshes"][0]["primitives"].push_back(other);
    }
    EXPECT_TRUE(hasNote(sceneOf(folder, gltf), "Left out: 13 lines and points.")); // 4 + 2 + 4 + 3
}

TEST(GltfMesh, PrimitivesWithoutPositionsAreLeftOut) {
    const TempFolder folder;
    json gltf = quadGltf();
    json other = primitiveOf(gltf);
    other["attributes"].erase("POSITION");
    gltf["meshes"][0]["primitives"].push_back(other);
    const Scene scene = sceneOf(folder, gltf);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_TRUE(hasNote(scene, "Primitives without positions are left out."));
}

TEST(GltfMesh, WithoutNormalsFacesAreFlat) {
    const TempFolder folder;
    json gltf = quadGltf();
    primitiveOf(gltf)["attributes"].erase("NORMAL");
    EXPECT_TRUE(sceneOf(folder, gltf).meshes.at(0).normals.empty());
}

json withTarget(json gltf) {
    const json target = {
        {"POSITION", addAccessor<float>(gltf, std::vector<float>(12, 4), "VEC3", 3)}};
    primitiveOf(gltf)["targets"] = json::array({target});
    return gltf;
}

TEST(GltfMesh, MorphTargetsByTheWeightsOfTheMesh) {
    const TempFolder folder;
    json gltf = withTarget(quadGltf());
    expectNear(sceneOf(folder, gltf).meshes.at(0).positions[2], {1, 1, 0}, 0);
    gltf["meshes"][0]["weights"] = {0.5};
    expectNear(sceneOf(folder, gltf).meshes.at(0).positions[2], {3, 3, 2}, 0);
}

TEST(GltfMesh, MorphTargetsByTheWeightsOfANode) {
    const TempFolder folder;
    json gltf = withTarget(quadGltf());
    gltf["meshes"][0]["weights"] = {0.5};
    gltf["scenes"][0]["nodes"] = {0, 1};
    gltf["nodes"].push_back({{"mesh", 0}, {"weights", {0.25}}});
    const Scene scene = sceneOf(folder, gltf);
    expectNear(scene.meshes.at(0).positions[2], {3, 3, 2}, 0);
    expectNear(scene.meshes.at(1).positions[2], {2, 2, 1}, 0);
}

// Two joints, one of which has moved since the mesh was bound; a vertex between them is halfway.
TEST(GltfMesh, SkinsStandAsTheirJointsDo) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["scenes"][0]["nodes"] = {0, 1, 2};
    gltf["nodes"][0]["skin"] = 0;
    gltf["nodes"][0]["translation"] = {100, 0, 0}; // counts not: joints alone move skins
    gltf["nodes"].push_back({{"translation", {1, 0, 0}}});
    gltf["nodes"].push_back({{"translation", {1, 10, 0}}});
    const std::vector<float> bound{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1,
                                   1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    gltf["skins"] =
        json::array({{{"joints", {1, 2}},
                      {"inverseBindMatrices", addAccessor<float>(gltf, bound, "MAT4", 16)}}});
    auto& attributes = primitiveOf(gltf)["attributes"];
    attributes["JOINTS_0"] =
        addAccessor<uint8_t>(gltf, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 4);
    attributes["WEIGHTS_0"] =
        addAccessor<float>(gltf, {1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4);
    const Scene scene = sceneOf(folder, gltf);
    const Mesh& mesh = scene.meshes.at(0);
    expectNear(mesh.positions[0], {0, 0, 0});
    expectNear(mesh.positions[2], {1, 11, 0});
    expectNear(mesh.positions[3], {0, 6, 0});
    expectNear(mesh.normals[3], {0, 0, 1});
    EXPECT_TRUE(hasNote(scene, "Skeletons stand as the file has them."));
}

TEST(GltfMesh, AccessorsThatDoNotFitAreErrors) {
    const TempFolder folder;
    const auto reasonOf = [&](const json& gltf) {
        const std::string error = errorOf(writeGltf(folder, gltf));
        return error.substr(error.find("': ") + 3);
    };
    json gltf = quadGltf();
    gltf["accessors"][0]["count"] = 5;
    EXPECT_EQ(reasonOf(gltf), "accessor 0 has 5 elements, more than buffer view 0 holds");
    gltf["accessors"][0]["count"] = uint64_t{1} << 62;
    EXPECT_EQ(reasonOf(gltf), "accessor 0 has a type or a count that glTF does not have");
    gltf = quadGltf();
    gltf["accessors"][0]["byteOffset"] = 48;
    EXPECT_EQ(reasonOf(gltf), "accessor 0 has 4 elements, more than buffer view 0 holds");
    gltf = quadGltf();
    gltf["bufferViews"][0]["byteLength"] = 400;
    EXPECT_EQ(reasonOf(gltf), "buffer view 0 is beyond the end of buffer 0, which has 140 bytes");
    gltf = quadGltf();
    primitiveOf(gltf)["attributes"]["POSITION"] = 9;
    EXPECT_EQ(reasonOf(gltf), "refers to accessor 9, of which there are 4");
    gltf = quadGltf();
    gltf["nodes"][0]["mesh"] = 7;
    EXPECT_EQ(reasonOf(gltf), "refers to mesh 7, of which there are 1");
}

// Indices that no vertex has cost their triangles.
TEST(GltfMesh, CornersThatDoNotExistAreCounted) {
    const TempFolder folder;
    json gltf = quadGltf();
    primitiveOf(gltf)["indices"] = addAccessor<uint32_t>(gltf, {0, 1, 2, 0, 2, 4}, "SCALAR", 1);
    const Scene scene = sceneOf(folder, gltf);
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 1u);
    EXPECT_TRUE(hasNote(scene, "1 triangles with a corner that is no number"));
}

TEST(GltfMesh, AttributesOfAnotherCountAreLeftOut) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["accessors"][1]["count"] = 3;
    const Scene scene = sceneOf(folder, gltf);
    EXPECT_TRUE(scene.meshes.at(0).normals.empty());
    EXPECT_TRUE(hasNote(scene, "NORMAL is left out"));
}

} // namespace
} // namespace wellstrat::render
