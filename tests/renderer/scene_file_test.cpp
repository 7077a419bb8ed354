// SPDX-License-Identifier: Apache-2.0
//
// Scene files: what is read, what is replaced, what is refused.

#include "renderer/color.h"
#include "renderer/scene_file.h"
#include "renderer/shapes.h"
#include "scene_files.h"

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace wellstrat::render {
namespace {

using nlohmann::json;

constexpr float kPi = 3.14159265f;

void expectNear(Float3 a, Float3 b, float tolerance = 1e-5f) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance);
}

bool hasNote(const Scene& scene, const std::string& part) {
    return std::any_of(scene.notes.begin(), scene.notes.end(), [&](const std::string& note) {
        return note.find(part) != std::string::npos;
    });
}

std::string errorOf(const std::string& path) {
    try {
        readScene(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

/// 2 x 2 pixels, upper row red and green, lower row blue and white.
std::string writeColors(const TempFolder& folder, const std::string& name) {
    const std::string path = folder.path(name);
    const uint8_t pixels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file->open(path, OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::UINT8)));
    EXPECT_TRUE(file->write_image(OIIO::TypeDesc::UINT8, pixels));
    EXPECT_TRUE(file->close());
    return path;
}

std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The color of the base texture where the mesh has this position.
Float3 textureAt(const Scene& scene, const Mesh& mesh, Float3 position) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if ((mesh.positions[i] - position).Length() > 1e-5f) continue;
        // The middle of the pixel in that corner.
        const Float2 uv = mesh.uvs[i] * 0.5f + Float2(0.25f, 0.25f);
        return scene.materials[mesh.material].baseColorTexture->lookup(uv);
    }
    ADD_FAILURE() << "no such vertex";
    return Float3(0.0f);
}

// ---- glTF ----

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
    gltf["extensionsUsed"] = {"KHR_materials_ior"};
    gltf["materials"][0]["extensions"]["KHR_materials_ior"]["ior"] = 2.0;
    const Scene scene = readScene(writeGltf(folder, gltf));
    EXPECT_NEAR(scene.materials[scene.meshes[0].material].specularF0, 1.0f / 9, 1e-6f);
}

json withTexture(json gltf, const json& image) {
    gltf["images"] = {image};
    gltf["textures"] = {{{"source", 0}}};
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
    gltf["extensionsUsed"] = {"KHR_texture_transform"};
    const json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0.0}}}}};
    auto& material = gltf["materials"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = transform;
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["extensions"] = transform;
    material["emissiveTexture"]["extensions"] = transform;
    const Scene scene = readScene(writeGltf(folder, gltf));
    const Mesh& mesh = scene.meshes.at(0);
    const auto upperLeft = std::find(mesh.positions.begin(), mesh.positions.end(), Float3(0, 1, 0));
    ASSERT_NE(upperLeft, mesh.positions.end());
    const Float2 uv = mesh.uvs[static_cast<std::size_t>(upperLeft - mesh.positions.begin())];
    EXPECT_NEAR(uv.x, 0.5f, 1e-5f);
    EXPECT_NEAR(uv.y, 0.0f, 1e-5f);
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
    gltf["extensionsUsed"] = {"KHR_materials_emissive_strength"};
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
    gltf["scenes"][0]["nodes"] = {0};
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

TEST(Gltf, OrthographicCamerasAreReplaced) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1.0}, {"ymag", 1.0}, {"zfar", 10.0}, {"znear", 0.1}}}}};
    gltf["scenes"][0]["nodes"] = {0, 1};
    gltf["nodes"].push_back({{"camera", 0}});
    const Scene scene = readScene(writeGltf(folder, gltf));
    EXPECT_TRUE(scene.cameraIsAutomatic);
    EXPECT_TRUE(hasNote(scene, "The camera is left out"));
}

json withLight(const json& light) {
    json gltf = quadGltf();
    gltf["extensionsUsed"] = {"KHR_lights_punctual"};
    gltf["extensions"]["KHR_lights_punctual"]["lights"] = {light};
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
    EXPECT_NEAR(scene.lights[0].cosOuter, std::cos(kPi / 4), 1e-6f);
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
    ASSERT_TRUE(scene.environment);
    EXPECT_TRUE(hasNote(scene, "There is no light"));
    ASSERT_TRUE(scene.camera);
    EXPECT_TRUE(scene.cameraIsAutomatic);
    EXPECT_TRUE(hasNote(scene, "There is no camera"));
    EXPECT_GT(scene.camera->position.z, 1.0f); // before the front of the quad
}

TEST(Gltf, SaysWhatIsLeftOut) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["materials"][0]["alphaMode"] = "BLEND";
    const Scene scene = readScene(writeGltf(folder, gltf));
    EXPECT_TRUE(hasNote(scene, "Transparency is left out"));
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

// A few bytes must not ask for 2^40 triangles.
TEST(Gltf, TooManyInstancesAreRefused) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["meshes"][0]["primitives"][0].erase("indices");
    gltf["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", 0}};
    const int count = 3'000'000;
    gltf["accessors"][0] = {
        {"bufferView", 0}, {"componentType", 5126}, {"count", count}, {"type", "VEC3"}};
    gltf["bufferViews"][0]["byteLength"] = count * 12;
    gltf["buffers"][0]["byteLength"] = count * 12;
    gltf["scenes"][0]["nodes"] = json::array();
    gltf["nodes"] = json::array();
    for (int i = 0; i < 110; ++i) {
        gltf["scenes"][0]["nodes"].push_back(i);
        gltf["nodes"].push_back({{"mesh", 0}});
    }
    const std::string path = writeGltf(folder, gltf);
    folder.write("quad.bin", std::string(count * 12, '\0'));
    EXPECT_NE(errorOf(path).find("has more than 100000000 triangles"), std::string::npos)
        << errorOf(path);
}

TEST(Gltf, MissingBuffersAreErrors) {
    const TempFolder folder;
    const std::string path = writeGltf(folder, quadGltf());
    std::filesystem::remove(folder.path("quad.bin"));
    EXPECT_NE(errorOf(path), "none");
}

// ---- OBJ with MTL ----

constexpr auto kObj = R"(mtllib scene.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl first
f 1/1 2/2 3/3 4/4
)";

Scene readObj(const TempFolder& folder, const std::string& material) {
    folder.write("scene.mtl", "newmtl first\n" + material);
    return readScene(folder.write("scene.obj", kObj));
}

TEST(Obj, PolygonsBecomeTriangles) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0.1 0.2 0.3\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.1f, 0.2f, 0.3f});
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.specularF0, 0.0f);
}

TEST(Obj, EmissiveMaterialsAreLights) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0 0 0\nKe 10 20 30\n");
    expectNear(scene.materials[scene.meshes[0].material].emission, {10, 20, 30});
    EXPECT_FALSE(scene.environment);
}

// Walter et al. 2007: alpha = sqrt(2 / (n + 2)); the roughness is its root.
TEST(Obj, PhongExponents) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nNs 198\n");
    const Material& material = scene.materials[scene.meshes[0].material];
    EXPECT_NEAR(material.roughness, std::sqrt(0.1f), 1e-5f);
    EXPECT_NEAR(material.specularF0, 0.04f, 1e-6f);
}

TEST(Obj, OnlySpecularIsMetal) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0 0 0\nKs 0.9 0.6 0.3\nNs 1000\n");
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.9f, 0.6f, 0.3f});
    EXPECT_EQ(material.metallic, 1.0f);
}

TEST(Obj, TexturesStandUpright) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("pictures"));
    writeColors(folder, "pictures/colors.png");
    const Scene scene = readObj(folder, "Kd 1 1 1\nmap_Kd pictures\\colors.png\n");
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_TRUE(scene.materials[mesh.material].baseColorTexture) << scene.notes.at(0);
    expectNear(textureAt(scene, mesh, {0, 1, 0}), {1, 0, 0});
    expectNear(textureAt(scene, mesh, {1, 1, 0}), {0, 1, 0});
    expectNear(textureAt(scene, mesh, {0, 0, 0}), {0, 0, 1});
}

TEST(Obj, AMissingMaterialLibraryIsNoTrouble) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", kObj));
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_LT(scene.meshes[0].material, scene.materials.size());
}

TEST(Obj, DropsWhatCannotBeRendered) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", R"(v 0 0 0
v 1 0 0
v 0 1 0
v nan 0 0
v 1e30 0 0
v 0.5 0 0
f 1 2 3
f 1 2 4
f 1 2 5
f 1 6 2
f 1 1 2
l 1 2
p 1
)"));
    uint64_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += mesh.triangles.size();
        for (const Float3& p : mesh.positions) EXPECT_LE(std::abs(p.x), 1.0f);
    }
    EXPECT_EQ(triangles, 1u);
    EXPECT_TRUE(hasNote(scene, "Left out: 2 triangles with a corner that is no number"));
    EXPECT_TRUE(hasNote(scene, "Left out: 2 triangles without area"));
    EXPECT_TRUE(hasNote(scene, "Left out: 2 lines and points"));
}

TEST(Obj, BrokenNormalsBecomeThoseOfTheFace) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", R"(v 0 0 0
v 1 0 0
v 0 1 0
vn 0 0 0
vn nan 0 1
vn 0 0 -5
f 1//1 2//2 3//3
)"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.normals.size(), 3u);
    expectNear(mesh.normals[0], {0, 0, 1});
    expectNear(mesh.normals[1], {0, 0, 1});
    expectNear(mesh.normals[2], {0, 0, -1});
}

// ---- other formats ----

TEST(Ply, IsRead) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.ply", R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
)"));
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
    EXPECT_TRUE(scene.cameraIsAutomatic);
    EXPECT_TRUE(scene.environment);
}

TEST(Stl, IsRead) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.stl", R"(solid s
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid s
)"));
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 1u);
}

// ---- errors ----

TEST(SceneFile, ErrorsNameTheFileInOneLine) {
    const TempFolder folder;
    EXPECT_EQ(errorOf("/no/such/scene.glb"),
              "cannot read scene '/no/such/scene.glb': no such file");
    EXPECT_EQ(errorOf(folder.path("")),
              "cannot read scene '" + folder.path("") + "': it is a folder");
    EXPECT_NE(errorOf("/dev/null").find("it is no ordinary file"), std::string::npos);
    for (const auto& path :
         {folder.write("empty.gltf", ""), folder.write("text.gltf", "hello\nworld"),
          folder.write("half.gltf", quadGltf().dump().substr(0, 200)),
          folder.write("text.glb", "glTF\2"), folder.write("scene.unknown", "hello"),
          folder.write("noextension", "hello"), folder.write("text.ply", "ply\n"),
          folder.write("text.fbx", "Kaydara"), folder.write("text.dae", "<a>")}) {
        const std::string error = errorOf(path);
        EXPECT_EQ(error.rfind("cannot read scene '" + path + "': ", 0), 0u) << error;
        EXPECT_GT(error.size(), path.size() + 24) << error;
        EXPECT_TRUE(std::none_of(error.begin(), error.end(),
                                 [](unsigned char c) { return std::iscntrl(c); }));
    }
}

TEST(SceneFile, WithoutTrianglesIsAnError) {
    const TempFolder folder;
    for (const auto& path : {folder.write("points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n"),
                             folder.write("degenerate.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
                             folder.write("nan.obj", "v nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                             folder.write("nothing.obj", "v 0 0 0\n"),
                             folder.write("scene.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
                                         "scenes": [{"nodes": []}]})")})
        EXPECT_NE(errorOf(path), "none") << path;
    EXPECT_NE(errorOf(folder.path("degenerate.obj")).find("no triangles to render"),
              std::string::npos);
}

// Files made to harm: nodes that contain themselves, endless chains, sizes beyond the file. Each
// may be read or refused; none may end the program.
TEST(SceneFile, HarmfulFilesDoNoHarm) {
    const TempFolder folder;
    json cycle = quadGltf();
    cycle["nodes"][0]["children"] = {0};
    json sizes = quadGltf();
    sizes["accessors"][0]["count"] = 4000000000u;
    json offsets = quadGltf();
    offsets["bufferViews"][0]["byteOffset"] = 1ull << 62;
    json indices = quadGltf();
    indices["accessors"][3]["byteOffset"] = 1000000;
    json chain = quadGltf();
    for (int i = 1; i <= 200000; ++i) {
        chain["nodes"][static_cast<std::size_t>(i) - 1]["children"] = {i};
        chain["nodes"].push_back({{"mesh", 0}});
    }
    for (const json& gltf : {cycle, sizes, offsets, indices, chain}) {
        const std::string path = writeGltf(folder, gltf);
        try {
            EXPECT_FALSE(readScene(path).meshes.empty());
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()).rfind("cannot read scene '", 0), 0u);
        }
    }
}

// ---- environment maps ----

TEST(EnvironmentMap, IsRead) {
    const TempFolder folder;
    const std::string path = folder.path("sky.hdr");
    const float pixels[] = {1, 2, 4, 100, 50, 25};
    const auto file = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(file->open(path, OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::FLOAT)));
    ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels));
    ASSERT_TRUE(file->close());
    const Environment environment = readEnvironment(path);
    ASSERT_TRUE(environment.map);
    EXPECT_EQ(environment.radiance, Float3(1.0f));
    expectNear(environment.map->pixel(0, 0), {1, 2, 4}, 0.05f);
    expectNear(environment.map->pixel(1, 0), {100, 50, 25}, 1.0f);
}

// The importer's process must not wait for threads that reading a picture here has started.
TEST(EnvironmentMap, CanBeReadAfterOtherPictures) {
    const TempFolder folder;
    const std::string path = folder.path("sky.exr");
    const std::vector<float> pixels(600 * 300 * 3, 0.5f);
    OIIO::ImageSpec spec(600, 300, 3, OIIO::TypeDesc::FLOAT);
    spec["compression"] = "zip";
    const auto file = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(file->open(path, spec));
    ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
    ASSERT_TRUE(file->close());
    EXPECT_EQ(readTexture(path, Encoding::linear).width(), 600u);
    EXPECT_EQ(readEnvironment(path).map->height(), 300u);
}

TEST(EnvironmentMap, ErrorsNameTheFile) {
    const TempFolder folder;
    EXPECT_THROW(readEnvironment(folder.write("sky.exr", "no picture")), std::runtime_error);
    try {
        readEnvironment("/no/such/sky.exr");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "cannot read environment map '/no/such/sky.exr': no such file");
    }
}

} // namespace
} // namespace wellstrat::render
