// SPDX-License-Identifier: Apache-2.0
//
// Nodes of glTF files: places, scenes, visibility, instances, lights and cameras.

#include "gltf_files.h"
#include "renderer/framing.h"
#include "renderer/lights.h"
#include "renderer/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wellstrat::render {
namespace {

using nlohmann::json;

Scene sceneOf(const TempFolder& folder, const json& gltf, const CameraChoice& camera = {}) {
    return readScene(writeGltf(folder, gltf), camera);
}

TEST(GltfNode, MirroringMatrices) {
    const TempFolder folder;
    json gltf = quadGltf();
    // x and y change places, and all moves.
    gltf["nodes"][0]["matrix"] = {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1};
    const Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    for (uint32_t i = 0; i < 2; ++i) expectNear(triangleAt(mesh, i, 0).areaNormal(), {0, 0, 1});
    expectNear(mesh.normals[0], {0, 0, 1});
    const auto has = [&](Float3 p) {
        return std::find(mesh.positions.begin(), mesh.positions.end(), p) != mesh.positions.end();
    };
    EXPECT_TRUE(has({5, 6, 7}) && has({5, 7, 7}) && has({6, 6, 7}) && has({6, 7, 7}));
}

// Of a plane that is scaled unevenly, the normal turns the other way than the plane.
TEST(GltfNode, NormalsOfUnevenScales) {
    const TempFolder folder;
    json gltf = quadGltf();
    const float half = std::sqrt(0.5f);
    gltf["accessors"][1] = {
        {"bufferView", 4}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}};
    std::string normals;
    for (int i = 0; i < 4; ++i) append<float>(normals, {half, 0, half});
    ASSERT_EQ(addView(gltf, normals), 4u);
    gltf["nodes"][0]["scale"] = {1, 1, -3};
    const Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.normals[0], {3 / std::sqrt(10.0f), 0, -1 / std::sqrt(10.0f)});
}

TEST(GltfNode, TheDefaultScene) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
    gltf["scenes"].push_back({{"nodes", {1}}});
    Scene scene = sceneOf(folder, gltf);
    ASSERT_EQ(scene.meshes.size(), 1u);
    expectNear(scene.meshes[0].positions[0], {0, 0, 0});
    EXPECT_TRUE(hasNote(scene, "There are 2 scenes: the file's default is rendered."));
    gltf["scene"] = 1;
    expectNear(sceneOf(folder, gltf).meshes.at(0).positions[0], {5, 0, 0});
    gltf.erase("scene");
    scene = sceneOf(folder, gltf);
    expectNear(scene.meshes.at(0).positions[0], {0, 0, 0});
    EXPECT_TRUE(hasNote(scene, "There are 2 scenes: the first is rendered."));
}

TEST(GltfNode, WithoutScenesAllNodes) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf.erase("scene");
    gltf.erase("scenes");
    gltf["nodes"].push_back({{"children", {0}}, {"translation", {5, 0, 0}}});
    const Scene scene = sceneOf(folder, gltf);
    ASSERT_EQ(scene.meshes.size(), 1u);
    expectNear(scene.meshes[0].positions[0], {5, 0, 0});
}

TEST(GltfNode, TreesThatAreNoneAreErrors) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["scenes"][0]["nodes"] = {0, 0};
    EXPECT_NE(errorOf(writeGltf(folder, gltf)).find("more than one way to node 0"),
              std::string::npos);
    gltf["scenes"][0]["nodes"] = {3};
    EXPECT_NE(errorOf(writeGltf(folder, gltf)).find("refers to node 3, of which there are 1"),
              std::string::npos);
}

// KHR_node_visibility hides meshes and lights below a node, even visible ones, and no cameras.
TEST(GltfNode, Visibility) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_node_visibility", "KHR_lights_punctual"});
    gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
    gltf["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    gltf["scenes"][0]["nodes"] = {0, 1};
    const auto visible = [](bool value) {
        return json{{"KHR_node_visibility", {{"visible", value}}}};
    };
    gltf["nodes"].push_back({{"children", {2, 3}}, {"extensions", visible(false)}});
    gltf["nodes"].push_back({{"mesh", 0}, {"extensions", visible(true)}});
    gltf["nodes"].push_back(
        {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    Scene scene = sceneOf(folder, gltf);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_FALSE(scene.cameraIsAutomatic);
    gltf["nodes"][1]["extensions"] = visible(true);
    scene = sceneOf(folder, gltf);
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(GltfNode, GpuInstances) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] = json::array({"EXT_mesh_gpu_instancing"});
    gltf["nodes"][0]["translation"] = {0, 0, 5};
    // The second: twice as large, half a turn about z (as normalized integers), moved.
    gltf["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", addAccessor<float>(gltf, {1, 0, 0, 0, 3, 0}, "VEC3", 3)},
        {"ROTATION", addAccessor<int8_t>(gltf, {0, 0, 0, 127, 0, 0, 127, 0}, "VEC4", 4, true)},
        {"SCALE", addAccessor<float>(gltf, {1, 1, 1, 2, 2, 2}, "VEC3", 3)}};
    const Scene scene = sceneOf(folder, gltf);
    ASSERT_EQ(scene.meshes.size(), 2u);
    expectNear(scene.meshes[0].positions[2], {2, 1, 5});
    expectNear(scene.meshes[1].positions[2], {-2, 1, 5});
    expectNear(scene.meshes[1].positions[0], {0, 3, 5});
}

/// A point light at nodes 1 and 2, of the same name.
json withTwoLights(const json& light) {
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_lights_punctual"});
    gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
    gltf["scenes"][0]["nodes"] = {0, 1, 2};
    for (const int x : {1, 2})
        gltf["nodes"].push_back({{"name", "lamp"},
                                 {"translation", {x, 0, 3}},
                                 {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return gltf;
}

TEST(GltfNode, OneLightAtTwoNodesOfOneName) {
    const TempFolder folder;
    const Scene scene = sceneOf(folder, withTwoLights({{"type", "point"}, {"intensity", 2}}));
    ASSERT_EQ(scene.lights.size(), 2u);
    expectNear(scene.lights[0].position, {1, 0, 3});
    expectNear(scene.lights[1].position, {2, 0, 3});
    EXPECT_TRUE(std::isinf(scene.lights[0].range));
}

// KHR_lights_punctual: intensity / d^2 times max(min(1 - (d / range)^4, 1), 0).
TEST(GltfNode, RangesOfLights) {
    const TempFolder folder;
    Scene scene =
        sceneOf(folder, withTwoLights({{"type", "point"}, {"intensity", 2}, {"range", 4}}));
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].range, 4.0f);
    scene.lights.resize(1);
    const Lights lights(scene);
    for (const float distance : {0.5f, 2.0f, 3.9f, 4.0f, 5.0f}) {
        const SurfacePoint receiver{{1, 0, 3 - distance}, {0, 0, 1}, 0};
        LightSample sample;
        const float ratio = distance / 4;
        const float window = std::max(1 - ratio * ratio * ratio * ratio, 0.0f);
        EXPECT_EQ(lights.sample(receiver, 0, {0.5f, 0.5f}, sample), window > 0.0f);
        if (window > 0.0f)
            expectNear(sample.radiance, Float3(2 * window / (distance * distance)), 1e-4f);
    }
}

json withCameras() {
    json gltf = quadGltf();
    gltf["cameras"] = {{{"type", "perspective"},
                        {"name", "eye"},
                        {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}},
                       {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
    gltf["scenes"][0]["nodes"] = {0, 1, 2, 3};
    gltf["nodes"].push_back({{"camera", 0}, {"translation", {1, 0, 9}}});
    gltf["nodes"].push_back({{"camera", 0}, {"name", "left"}, {"translation", {2, 0, 9}}});
    gltf["nodes"].push_back({{"camera", 1}, {"name", "left"}, {"translation", {3, 0, 9}}});
    return gltf;
}

TEST(GltfNode, CamerasWithoutAspect) {
    const TempFolder folder;
    const Scene scene = sceneOf(folder, withCameras());
    ASSERT_TRUE(scene.camera);
    EXPECT_FALSE(scene.cameraIsAutomatic);
    EXPECT_NEAR(scene.camera->verticalFov, 0.5f, 1e-6f);
    EXPECT_EQ(scene.aspect, 1.0f);
}

TEST(GltfNode, CamerasAreChosen) {
    const TempFolder folder;
    const auto x = [&](const CameraChoice& choice) {
        return sceneOf(folder, withCameras(), choice).camera.value().position.x;
    };
    EXPECT_EQ(x({}), 1);
    EXPECT_EQ(x({{}, 3}), 3);
    EXPECT_EQ(x({"left", {}}), 2);
    EXPECT_EQ(x({"left", 2}), 3);
    EXPECT_EQ(x({"eye", 2}), 2); // by the camera's own name
    EXPECT_TRUE(hasNote(sceneOf(folder, withCameras()),
                        "There are 3 cameras, 'eye', 'left', 'left': the first is used."));
}

TEST(GltfNode, CamerasThatDoNotExistAreErrors) {
    const TempFolder folder;
    const std::string path = writeGltf(folder, withCameras());
    const auto reasonOf = [&](const CameraChoice& choice) {
        try {
            readScene(path, choice);
        } catch (const std::runtime_error& error) {
            return std::string(error.what()).substr(std::string(error.what()).find("': ") + 3);
        }
        return std::string("none");
    };
    EXPECT_EQ(reasonOf({"right", {}}), "it has no such camera, only 3: 'eye', 'left', 'left'");
    EXPECT_EQ(reasonOf({{}, 4}), "it has no such camera, only 3: 'eye', 'left', 'left'");
    EXPECT_EQ(reasonOf({"left", 3}), "it has no such camera, only 3: 'eye', 'left', 'left'");
}

} // namespace
} // namespace wellstrat::render
