// SPDX-License-Identifier: Apache-2.0
//
// glTF files: all that is read of them, and what is not.

#include "renderer/color.h"
#include "renderer/import/import_scene.h"
#include "renderer/shapes.h"
#include "scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wellstrat::render {
namespace {

using nlohmann::json;

TEST(Gltf, Geometry) {
    const TempFolder folder;
    const Scene scene = readScene(writeGltf(folder, quadGltf()));
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.normals.size(), 4u);
    EXPECT_EQ(mesh.normals[0], Float3(0, 0, 1));
    EXPECT_EQ(mesh.uvs.size(), 4u);
    for (uint32_t i = 0; i < 2; ++i) expectNear(triangleAt(mesh, i, 0).areaNormal(), {0, 0, 1});
}

TEST(Gltf, MetallicRoughnessFactors) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["materials"][0] = {{"pbrMetallicRoughness",
                             {{"baseColorFactor", {0.1, 0.2, 0.3, 1}},
                              {"metallicFactor", 0.25},
                              {"roughnessFactor", 0.75}}},
                            {"doubleSided", true}};
    const Scene scene = readScene(writeGltf(folder, gltf));
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.1f, 0.2f, 0.3f});
    EXPECT_FLOAT_EQ(material.metallic, 0.25f);
    EXPECT_FLOAT_EQ(material.roughness, 0.75f);
    EXPECT_FLOAT_EQ(material.specularF0, 0.04f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(isBlack(material.emission));
}

TEST(Gltf, DefaultsOfTheSpecification) {
    const TempFolder folder;
    const Scene scene = readScene(writeGltf(folder, quadGltf()));
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, Float3(1.0f));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_FALSE(material.doubleSided);
}

TEST(Gltf, IndexOfRefraction) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_materials_ior"});
    gltf["materials"][0]["extensions"]["KHR_materials_ior"]["ior"] = 2.0;
    const Scene scene = readScene(writeGltf(folder, gltf));
    EXPECT_NEAR(scene.materials[scene.meshes[0].material].specularF0, 1.0f / 9, 1e-6f);
}

json withTexture(json gltf, const json& image) {
    gltf["images"] = json::array({image});
    gltf["textures"] = json::array({{{"source", 0}}});
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    gltf["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    gltf["materials"][0]["emissiveTexture"] = {{"index", 0}};
    gltf["materials"][0]["emissiveFactor"] = {1, 1, 1};
    return gltf;
}

/// Red is upper left of the picture, and so of the quad.
void expectUpright(const Scene& scene) {
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_TRUE(scene.materials[mesh.material].baseColorTexture);
    ASSERT_TRUE(scene.materials[mesh.material].metallicRoughnessTexture);
    ASSERT_TRUE(scene.materials[mesh.material].emissionTexture);
    expectNear(textureAt(scene, mesh, {0, 1, 0}), {1, 0, 0});
    expectNear(textureAt(scene, mesh, {1, 1, 0}), {0, 1, 0});
    expectNear(textureAt(scene, mesh, {0, 0, 0}), {0, 0, 1});
    expectNear(textureAt(scene, mesh, {1, 0, 0}), {1, 1, 1});
}

TEST(Gltf, ExternalTextures) {
    const TempFolder folder;
    writeColors(folder, "my colors.png");
    for (const char* uri : {"my colors.png", "my%20colors.png"})
        expectUpright(readScene(writeGltf(folder, withTexture(quadGltf(), {{"uri", uri}}))));
}

TEST(Gltf, EmbeddedTexturesOfBinaryFiles) {
    const TempFolder folder;
    const std::string picture = bytesOf(writeColors(folder, "colors.png"));
    json gltf = withTexture(quadGltf(), {{"bufferView", 4}, {"mimeType", "image/png"}});
    gltf["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", 140}, {"byteLength", picture.size()}});
    gltf["buffers"][0] = {{"byteLength", 140 + picture.size()}};
    std::filesystem::remove(folder.path("colors.png"));
    expectUpright(readScene(folder.write("scene.glb", glb(gltf, quadBuffer() + picture))));
}

TEST(Gltf, TextureTransforms) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    json gltf = withTexture(quadGltf(), {{"uri", "colors.png"}});
    gltf["extensionsUsed"] = json::array({"KHR_texture_transform"});
    const json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.0}}}}};
    auto& material = gltf["materials"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = transform;
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["extensions"] = transform;
    material["emissiveTexture"]["extensions"] = transform;
    const Scene scene = readScene(writeGltf(folder, gltf));
    const Material& read = scene.materials[scene.meshes.at(0).material];
    // Green is half a picture to the right of red.
    for (const TextureMap* map :
         {&read.baseColorTexture, &read.metallicRoughnessTexture, &read.emissionTexture})
        expectNear(map->lookup({{0.25f, 0.25f}, {}}), {0, 1, 0});
}

TEST(Gltf, AMissingTextureLeavesTheFactor) {
    const TempFolder folder;
    json gltf = withTexture(quadGltf(), {{"uri", "nowhere.png"}});
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.5, 0.5, 1};
    const Scene scene = readScene(writeGltf(folder, gltf));
    const Material& material = scene.materials[scene.meshes[0].material];
    EXPECT_FALSE(material.baseColorTexture);
    expectNear(material.baseColor, Float3(0.5f));
    EXPECT_TRUE(hasNote(scene, "The texture 'nowhere.png' is left out: no such file."));
}

TEST(Gltf, ABrokenTextureLeavesTheFactor) {
    const TempFolder folder;
    folder.write("broken.png", "no picture");
    const Scene scene =
        readScene(writeGltf(folder, withTexture(quadGltf(), {{"uri", "broken.png"}})));
    EXPECT_FALSE(scene.materials[scene.meshes[0].material].baseColorTexture);
    EXPECT_TRUE(hasNote(scene, "The texture 'broken.png' is left out"));
}

TEST(Gltf, EmissiveMaterialsAreLights) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["materials"][0]["emissiveFactor"] = {0.5, 0.25, 1.0};
    const Scene scene = readScene(writeGltf(folder, gltf));
    expectNear(scene.materials[scene.meshes[0].material].emission, {0.5f, 0.25f, 1.0f});
    EXPECT_FALSE(scene.environment);
}

json strong() {
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_materials_emissive_strength"});
    gltf["materials"][0]["emissiveFactor"] = {0.5, 0.25, 1.0};
    gltf["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 40;
    return gltf;
}

TEST(Gltf, EmissiveStrength) {
    const TempFolder folder;
    const Scene scene = readScene(writeGltf(folder, strong()));
    expectNear(scene.materials[scene.meshes[0].material].emission, {20, 10, 40});
}

TEST(Gltf, EmissiveStrengthInBinaryFiles) {
    const TempFolder folder;
    json gltf = strong();
    gltf["buffers"][0].erase("uri");
    const Scene scene = readScene(folder.write("scene.glb", glb(gltf, quadBuffer())));
    expectNear(scene.materials[scene.meshes[0].material].emission, {20, 10, 40});
}

// Flattened into world space: translation, rotation and scale down the tree, an instance each.
TEST(Gltf, NodesAndInstances) {
    const TempFolder folder;
    json gltf = quadGltf();
    const float half = std::sqrt(0.5f);
    gltf["scenes"][0]["nodes"] = json::array({0});
    gltf["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1, 2}}},
                     {{"mesh", 0}, {"rotation", {0, half, 0, half}}}, // 90 degrees about y
                     {{"mesh", 0}, {"scale", {2, 3, 1}}, {"translation", {0, 0, -1}}}};
    const Scene scene = readScene(writeGltf(folder, gltf));
    ASSERT_EQ(scene.meshes.size(), 2u);
    const auto has = [](const Mesh& mesh, Float3 p) {
        return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                           [&](Float3 q) { return (p - q).Length() < 1e-5f; });
    };
    EXPECT_TRUE(has(scene.meshes[0], {10, 1, -1}));
    expectNear(scene.meshes[0].normals[0], {1, 0, 0});
    EXPECT_TRUE(has(scene.meshes[1], {12, 3, -1}));
    expectNear(scene.meshes[1].normals[0], {0, 0, 1});
}

// A mirror turns the order of corners round; the front must stay in front.
TEST(Gltf, MirroredNodesKeepTheirFront) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["nodes"][0]["scale"] = {-1, 1, 1};
    const Scene scene = readScene(writeGltf(folder, gltf));
    const Mesh& mesh = scene.meshes[0];
    expectNear(triangleAt(mesh, 0, 0).areaNormal(), {0, 0, 1});
    expectNear(mesh.normals[0], {0, 0, 1});
}

TEST(Gltf, PerspectiveCameras) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["cameras"] = {{{"type", "perspective"},
                        {"perspective", {{"yfov", 0.7}, {"aspectRatio", 1.6}, {"znear", 0.1}}}}};
    gltf["scenes"][0]["nodes"] = {0, 1};
    const float half = std::sqrt(0.5f); // -90 degrees about x: looks down
    gltf["nodes"].push_back({{"camera", 0},
                             {"translation", {1, 2, 3}},
                             {"rotation", {-half, 0, 0, half}},
                             {"scale", {5, 5, 5}}});
    const Scene scene = readScene(writeGltf(folder, gltf));
    ASSERT_TRUE(scene.camera);
    EXPECT_FALSE(scene.cameraIsAutomatic);
    expectNear(scene.camera->position, {1, 2, 3});
    expectNear(scene.camera->forward, {0, -1, 0});
    expectNear(scene.camera->up, {0, 0, -1});
    EXPECT_NEAR(scene.camera->verticalFov, 0.7f, 1e-5f);
    EXPECT_NEAR(scene.aspect, 1.6f, 1e-5f);
    EXPECT_EQ(scene.camera->lensRadius, 0.0f);
}

TEST(Gltf, OrthographicCameras) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1.5}, {"ymag", 0.5}, {"zfar", 10.0}, {"znear", 0.1}}}}};
    gltf["scenes"][0]["nodes"] = {0, 1};
    gltf["nodes"].push_back({{"camera", 0}});
    const Scene scene = readScene(writeGltf(folder, gltf));
    ASSERT_TRUE(scene.camera);
    EXPECT_FALSE(scene.cameraIsAutomatic);
    EXPECT_EQ(scene.camera->orthographicHeight, 1.0f);
    EXPECT_EQ(scene.aspect, 3.0f);
}

json withLight(const json& light) {
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_lights_punctual"});
    gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
    gltf["scenes"][0]["nodes"] = {0, 1};
    const float half = std::sqrt(0.5f); // -90 degrees about x: shines down
    gltf["nodes"].push_back({{"name", "lamp"},
                             {"translation", {1, 2, 3}},
                             {"rotation", {-half, 0, 0, half}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return gltf;
}

TEST(Gltf, PointLights) {
    const TempFolder folder;
    const Scene scene = readScene(writeGltf(
        folder, withLight({{"type", "point"}, {"color", {1, 0.5, 0.25}}, {"intensity", 8}})));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, PunctualLight::Kind::point);
    expectNear(scene.lights[0].position, {1, 2, 3});
    expectNear(scene.lights[0].intensity, {8, 4, 2});
    EXPECT_FALSE(scene.environment);
}

TEST(Gltf, SpotLights) {
    const TempFolder folder;
    const Scene scene = readScene(writeGltf(
        folder, withLight({{"type", "spot"},
                           {"intensity", 5},
                           {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.5}}}})));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, PunctualLight::Kind::spot);
    expectNear(scene.lights[0].direction, {0, -1, 0});
    expectNear(scene.lights[0].intensity, Float3(5.0f));
    EXPECT_NEAR(scene.lights[0].cosInner, std::cos(0.3f), 1e-6f);
    EXPECT_NEAR(scene.lights[0].cosOuter, std::cos(0.5f), 1e-6f);
}

TEST(Gltf, SpotLightsHaveTheAnglesOfTheSpecification) {
    const TempFolder folder;
    const Scene scene =
        readScene(writeGltf(folder, withLight({{"type", "spot"}, {"spot", json::object()}})));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_NEAR(scene.lights[0].cosInner, 1.0f, 1e-6f);
    EXPECT_NEAR(scene.lights[0].cosOuter, std::sqrt(0.5f), 1e-6f);
}

TEST(Gltf, DirectionalLights) {
    const TempFolder folder;
    const Scene scene =
        readScene(writeGltf(folder, withLight({{"type", "directional"}, {"intensity", 3}})));
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, PunctualLight::Kind::directional);
    expectNear(scene.lights[0].direction, {0, -1, 0});
    expectNear(scene.lights[0].intensity, Float3(3.0f));
}

TEST(Gltf, WithoutLightAndCamera) {
    const TempFolder folder;
    const Scene scene = readScene(writeGltf(folder, quadGltf()));
    EXPECT_FALSE(scene.environment);
    ASSERT_TRUE(scene.camera);
    EXPECT_TRUE(scene.cameraIsAutomatic);
    EXPECT_TRUE(hasNote(scene, "There is no camera"));
    EXPECT_GT(scene.camera->position.z, 1.0f); // before the front of the quad
}

TEST(Gltf, SaysWhatIsLeftOut) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_materials_clearcoat"});
    const Scene scene = readScene(writeGltf(folder, gltf));
    EXPECT_TRUE(hasNote(scene, "What KHR_materials_clearcoat says is left out."));
}

TEST(Gltf, NumbersOutOfRangeAreClamped) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {2, -1, 0.5, 1}},
                                                    {"roughnessFactor", 7}};
    gltf["materials"][0]["emissiveFactor"] = {-1, 0, 0};
    const Scene scene = readScene(writeGltf(folder, gltf));
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {1, 0, 0.5f});
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_TRUE(isBlack(material.emission));
    EXPECT_TRUE(hasNote(scene, "outside [0, 1]"));
    EXPECT_TRUE(hasNote(scene, "negative"));
}

// The triangles of a mesh count as often as nodes refer to it.
TEST(Gltf, TooManyInstancesAreRefused) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["scenes"][0]["nodes"] = {0, 1};
    gltf["nodes"].push_back({{"mesh", 0}, {"translation", {2, 0, 0}}});
    const std::string path = writeGltf(folder, gltf);
    EXPECT_EQ(importScene(path, 4).meshes.size(), 2u);
    try {
        importScene(path, 3);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "has more than 3 triangles, all instances counted");
    }
}

TEST(Gltf, ShortBinaryFilesAreErrors) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["buffers"][0].erase("uri");
    const std::string bytes = glb(gltf, quadBuffer());
    EXPECT_EQ(errorOf(folder.write("whole.glb", bytes)), "none");
    for (const std::size_t size : {std::size_t{24}, std::size_t{200}, bytes.size() - 1}) {
        const auto path = folder.write("short.glb", bytes.substr(0, size));
        EXPECT_NE(errorOf(path).find("the file is shorter than its header says"),
                  std::string::npos);
    }
}

TEST(Gltf, MissingBuffersAreErrors) {
    const TempFolder folder;
    const std::string path = writeGltf(folder, quadGltf());
    std::filesystem::remove(folder.path("quad.bin"));
    EXPECT_NE(errorOf(path), "none");
}

} // namespace
} // namespace wellstrat::render
