// SPDX-License-Identifier: Apache-2.0
//
// Materials and textures of glTF files.

#include "gltf_files.h"
#include "renderer/color.h"
#include "renderer/opacity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wellstrat::render {
namespace {

using nlohmann::json;

Scene sceneOf(const TempFolder& folder, const json& gltf) {
    return readScene(writeGltf(folder, gltf));
}

/// Writes a picture of four channels, the last of them alpha that the colors are not multiplied by.
std::string writeRgba(const TempFolder& folder, const std::string& name, int width,
                      const std::vector<uint8_t>& pixels) {
    const std::string path = folder.path(name);
    OIIO::ImageSpec spec(width, static_cast<int>(pixels.size()) / 4 / width, 4,
                         OIIO::TypeDesc::UINT8);
    spec["oiio:UnassociatedAlpha"] = 1;
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file->open(path, spec));
    EXPECT_TRUE(file->write_image(OIIO::TypeDesc::UINT8, pixels.data()));
    EXPECT_TRUE(file->close());
    return path;
}

/// The quad with one picture as its texture 0.
json withPicture(const std::string& uri) {
    json gltf = quadGltf();
    gltf["images"] = json::array({{{"uri", uri}}});
    gltf["textures"] = json::array({{{"source", 0}}});
    gltf["materials"][0]["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}},
                                                    {"metallicRoughnessTexture", {{"index", 0}}}};
    gltf["materials"][0]["emissiveTexture"] = {{"index", 0}};
    gltf["materials"][0]["emissiveFactor"] = {1, 1, 1};
    return gltf;
}

// 0.8 of 255 is 0.603827 in linear color, 0.4 is 0.132868, 0.2 is 0.033105: IEC 61966-2-1.
TEST(GltfMaterial, AlphaIsNoColor) {
    const TempFolder folder;
    writeRgba(folder, "a.png", 1, {204, 102, 51, 26});
    const Material material = materialOf(sceneOf(folder, withPicture("a.png")));
    expectNear(material.baseColorTexture.lookup({}), {0.603827f, 0.132868f, 0.033105f}, 1e-5f);
    expectNear(material.emissionTexture.lookup({}), {0.603827f, 0.132868f, 0.033105f}, 1e-5f);
    expectNear(material.metallicRoughnessTexture.lookup({}), {0.8f, 0.4f, 0.2f}, 1e-5f);
}

TEST(GltfMaterial, ColorsWhereAlphaIsZero) {
    const TempFolder folder;
    writeRgba(folder, "a.png", 1, {255, 102, 0, 0});
    expectNear(
        materialOf(sceneOf(folder, withPicture("a.png"))).metallicRoughnessTexture.lookup({}),
        {1, 0.4f, 0}, 1e-5f);
}

/// The place (u, v) of the texture where KHR_texture_transform puts (u, v), by a picture whose red
/// is u and whose green is v.
class TextureTransform : public ::testing::Test {
protected:
    TextureTransform() {
        std::vector<uint8_t> pixels;
        for (unsigned y = 0; y < 128; ++y)
            for (unsigned x = 0; x < 128; ++x)
                pixels.insert(pixels.end(),
                              {static_cast<uint8_t>(2 * x), static_cast<uint8_t>(2 * y), 0, 255});
        writeRgba(folder_, "uv.png", 128, pixels);
        gltf_ = withPicture("uv.png");
        gltf_["extensionsUsed"] = json::array({"KHR_texture_transform"});
    }

    Material materialWith(const json& transform) {
        gltf_["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["extensions"] = {
            {"KHR_texture_transform", transform}};
        return materialOf(sceneOf(folder_, gltf_));
    }

    static Float2 placeOf(const TextureMap& map, Float2 uv) {
        const Float3 color = map.lookup({uv, {0.6f, 0.7f}});
        return {(color.x * 127.5f + 0.5f) / 128, (color.y * 127.5f + 0.5f) / 128};
    }

    TempFolder folder_;
    json gltf_;
};

TEST_F(TextureTransform, FollowsTheSpecificationAtManyPoints) {
    const double offset[] = {0.45, 0.375}, rotation = 0.3, scale[] = {0.25, 0.5};
    const TextureMap map =
        materialWith({{"offset", {0.45, 0.375}}, {"rotation", 0.3}, {"scale", {0.25, 0.5}}})
            .metallicRoughnessTexture;
    for (const double u : {0.1, 0.4, 0.7, 1.0}) {
        for (const double v : {0.0, 0.35, 0.6, 0.8}) {
            const double x = scale[0] * u, y = scale[1] * v;
            const double c = std::cos(rotation), s = std::sin(rotation);
            const Float2 place = placeOf(map, {static_cast<float>(u), static_cast<float>(v)});
            EXPECT_NEAR(place.x, offset[0] + c * x + s * y, 1e-3) << u << " " << v;
            EXPECT_NEAR(place.y, offset[1] - s * x + c * y, 1e-3) << u << " " << v;
        }
    }
}

// The example of the specification: the lower left quarter of the picture, turned.
TEST_F(TextureTransform, TakesTheQuarterOfTheExample) {
    const TextureMap map =
        materialWith({{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}})
            .metallicRoughnessTexture;
    const Float2 place = placeOf(map, {0.3f, 0.6f});
    EXPECT_NEAR(place.x, 0.3, 1e-3);
    EXPECT_NEAR(place.y, 0.85, 1e-3);
}

TEST_F(TextureTransform, IsOfOneTextureOnly) {
    const Material material = materialWith({{"scale", {0.5, 0.25}}});
    EXPECT_NEAR(placeOf(material.metallicRoughnessTexture, {0.4f, 0.8f}).y, 0.2, 1e-3);
    EXPECT_EQ(material.baseColorTexture.transform.u.x, 1.0f);
}

TEST_F(TextureTransform, HasItsOwnTextureCoordinates) {
    auto& attributes = primitiveOf(gltf_)["attributes"];
    attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
    gltf_["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"]["texCoord"] = 5;
    const Material material = materialWith({{"texCoord", 1}});
    EXPECT_FALSE(material.baseColorTexture.takesSecondUv);
    EXPECT_TRUE(material.metallicRoughnessTexture.takesSecondUv);
    EXPECT_NEAR(placeOf(material.metallicRoughnessTexture, {0, 0}).x, 0.6, 1e-3);
    EXPECT_EQ(sceneOf(folder_, gltf_).meshes.at(0).secondUvs.size(), 4u);
}

// Whatever numbers the two sets have in the file.
TEST(GltfMaterial, AnySetOfTextureCoordinates) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    json gltf = withPicture("colors.png");
    primitiveOf(gltf)["attributes"]["TEXCOORD_3"] =
        addAccessor<float>(gltf, {7, 7, 7, 7, 7, 7, 7, 7}, "VEC2", 2);
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 3;
    const Scene scene = sceneOf(folder, gltf);
    EXPECT_EQ(scene.meshes.at(0).uvs.at(0).x, 7.0f);
    EXPECT_EQ(scene.meshes.at(0).secondUvs.at(1).x, 1.0f);
    EXPECT_FALSE(materialOf(scene).baseColorTexture.takesSecondUv);
    EXPECT_TRUE(materialOf(scene).emissionTexture.takesSecondUv);
}

/// The red of the texture at u = v, for a sampler. The picture is red, green, blue, white.
Float3 colorAt(const TempFolder& folder, const json& sampler, Float2 uv) {
    writeColors(folder, "colors.png");
    json gltf = withPicture("colors.png");
    gltf["samplers"] = json::array({sampler});
    gltf["textures"][0]["sampler"] = 0;
    return materialOf(sceneOf(folder, gltf)).metallicRoughnessTexture.lookup({uv, {}});
}

TEST(GltfMaterial, WrapModesOfBothAxes) {
    const TempFolder folder;
    const Float3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1.0f);
    constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648;
    const auto at = [&](int s, int t, Float2 uv) {
        return colorAt(folder, {{"wrapS", s}, {"wrapT", t}}, uv);
    };
    expectNear(at(kRepeat, kRepeat, {1.25f, 0.25f}), red);
    expectNear(at(kClamp, kRepeat, {1.25f, 0.25f}), green);
    expectNear(at(kClamp, kRepeat, {-7.25f, 1.75f}), blue);
    expectNear(at(kMirror, kRepeat, {1.25f, 0.25f}), green);
    expectNear(at(kMirror, kRepeat, {2.25f, 0.25f}), red);
    expectNear(at(kMirror, kRepeat, {-0.25f, 0.25f}), red);
    expectNear(at(kRepeat, kClamp, {0.25f, -0.75f}), red);
    expectNear(at(kRepeat, kClamp, {0.25f, 7}), blue);
    expectNear(at(kRepeat, kMirror, {0.75f, 1.25f}), white);
    expectNear(at(kRepeat, kMirror, {0.75f, -1.25f}), white);
    // At a border, repeating pictures blend into their other end, others do not.
    expectNear(at(kRepeat, kClamp, {0, 0}), (red + green) * 0.5f);
    expectNear(at(kClamp, kClamp, {0, 0}), red);
    expectNear(at(kMirror, kMirror, {1, 1}), white);
}

TEST(GltfMaterial, FilterModes) {
    const TempFolder folder;
    constexpr int kNearest = 9728, kLinear = 9729;
    const Float2 uv(0.45f, 0.25f);
    expectNear(colorAt(folder, {{"magFilter", kNearest}}, uv), {1, 0, 0});
    expectNear(colorAt(folder, {{"magFilter", kNearest}}, {0.55f, 0.25f}), {0, 1, 0});
    expectNear(colorAt(folder, {{"magFilter", kNearest}}, {0.999f, 0.999f}), Float3(1.0f));
    expectNear(colorAt(folder, {{"magFilter", kLinear}, {"minFilter", kNearest}}, uv),
               {0.6f, 0.4f, 0});
    expectNear(colorAt(folder, json::object(), uv), {0.6f, 0.4f, 0});
}

TEST(GltfMaterial, AlphaModes) {
    const TempFolder folder;
    writeRgba(folder, "a.png", 1, {204, 102, 51, 102});
    json gltf = withPicture("a.png");
    auto& material = gltf["materials"][0];
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.5};
    Material read = materialOf(sceneOf(folder, gltf));
    EXPECT_EQ(read.alpha, Material::Alpha::opaque);
    EXPECT_EQ(opacityAt(read, {}), 1.0f);
    material["alphaMode"] = "BLEND";
    read = materialOf(sceneOf(folder, gltf));
    EXPECT_EQ(read.alpha, Material::Alpha::blend);
    EXPECT_FLOAT_EQ(opacityAt(read, {}), 0.5f * 0.4f);
    expectNear(read.baseColorTexture.lookup({}), {0.603827f, 0.132868f, 0.033105f}, 1e-5f);
    material["alphaMode"] = "MASK";
    EXPECT_EQ(opacityAt(materialOf(sceneOf(folder, gltf)), {}), 0.0f);
    material["alphaCutoff"] = 0.19;
    EXPECT_EQ(opacityAt(materialOf(sceneOf(folder, gltf)), {}), 1.0f);
}

TEST(GltfMaterial, VertexColors) {
    const TempFolder folder;
    json gltf = quadGltf();
    auto& attributes = primitiveOf(gltf)["attributes"];
    attributes["COLOR_0"] = addAccessor<uint8_t>(
        gltf, {255, 0, 51, 0, 255, 0, 0, 0, 255, 255, 255, 255}, "VEC3", 3, true);
    Mesh mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.colors.at(0).color, {1, 0, 0.2f});
    EXPECT_EQ(mesh.colors[0].opacity, 1.0f);
    attributes["COLOR_0"] = addAccessor<uint16_t>(
        gltf, {65535, 0, 0, 13107, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4, true);
    mesh = sceneOf(folder, gltf).meshes.at(0);
    expectNear(mesh.colors.at(0).color, {1, 0, 0});
    EXPECT_FLOAT_EQ(mesh.colors[0].opacity, 0.2f);
}

TEST(GltfMaterial, NormalMaps) {
    const TempFolder folder;
    writeRgba(folder, "n.png", 1, {204, 102, 255, 255});
    json gltf = withPicture("n.png");
    gltf["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", 0.5}};
    const Material material = materialOf(sceneOf(folder, gltf));
    expectNear(material.normalTexture.lookup({}), {0.8f, 0.4f, 1});
    EXPECT_EQ(material.normalScale, 0.5f);
}

TEST(GltfMaterial, SpecularGlossiness) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] =
        json::array({"KHR_materials_pbrSpecularGlossiness"});
    gltf["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
        {"diffuseFactor", {0.5, 0.25, 0.125, 1}},
        {"specularFactor", {0.1, 0.2, 0.3}},
        {"glossinessFactor", 0.75}};
    const Material material = materialOf(sceneOf(folder, gltf));
    expectNear(material.baseColor, {0.5f, 0.25f, 0.125f});
    expectNear(material.specularColor * material.specularF0, {0.1f, 0.2f, 0.3f});
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_FLOAT_EQ(material.roughness, 0.25f);
}

// Of its texture, colors are specular and alpha is glossiness.
TEST(GltfMaterial, SpecularGlossinessTextures) {
    const TempFolder folder;
    writeRgba(folder, "sg.png", 1, {255, 128, 0, 51});
    json gltf = withPicture("sg.png");
    gltf["extensionsUsed"] = json::array({"KHR_materials_pbrSpecularGlossiness"});
    gltf["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
        {"glossinessFactor", 0.5}, {"specularGlossinessTexture", {{"index", 0}}}};
    const Material material = materialOf(sceneOf(folder, gltf));
    expectNear(material.specularColorTexture.lookup({}), {1, 0.215861f, 0}, 1e-5f);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_NEAR(material.metallicRoughnessTexture.lookup({}).y, 1 - 0.5f * 0.2f, 1e-6f);
    EXPECT_FALSE(material.baseColorTexture);
}

TEST(GltfMaterial, Unlit) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    json gltf = withPicture("colors.png");
    gltf["extensionsUsed"] = json::array({"KHR_materials_unlit"});
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 1, 1};
    gltf["materials"][0]["extensions"]["KHR_materials_unlit"] = json::object();
    const Scene scene = sceneOf(folder, gltf);
    const Material material = materialOf(scene);
    expectNear(material.emission, {0.5f, 0.25f, 1});
    expectNear(material.emissionTexture.lookup({{0.25f, 0.25f}, {}}), {1, 0, 0});
    EXPECT_TRUE(isBlack(material.baseColor));
    EXPECT_EQ(material.specularF0, 0.0f);
    EXPECT_TRUE(material.colorIsEmission);
    EXPECT_TRUE(hasNote(scene, "Unlit surfaces give off their color as light."));
}

TEST(GltfMaterial, Specular) {
    const TempFolder folder;
    writeRgba(folder, "s.png", 1, {255, 255, 255, 51});
    json gltf = withPicture("s.png");
    gltf["extensionsUsed"] = json::array({"KHR_materials_specular"});
    gltf["materials"][0]["extensions"]["KHR_materials_specular"] = {
        {"specularFactor", 0.5},
        {"specularColorFactor", {2, 1, 0}},
        {"specularTexture", {{"index", 0}}}};
    const Material material = materialOf(sceneOf(folder, gltf));
    EXPECT_FLOAT_EQ(material.specularF0, 0.02f);
    expectNear(material.specularColor, {2, 1, 0});
    expectNear(material.specularTexture.lookup({}), Float3(0.2f));
}

TEST(GltfMaterial, Transmission) {
    const TempFolder folder;
    writeRgba(folder, "a.png", 1, {204, 102, 51, 255});
    json gltf = quadGltf();
    gltf["images"] = json::array({{{"uri", "a.png"}}});
    gltf["textures"] = json::array({{{"source", 0}}});
    json& extensions = gltf["materials"][0]["extensions"];
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", 0.75},
                                                {"transmissionTexture", {{"index", 0}}}};
    Material material = materialOf(sceneOf(folder, gltf));
    EXPECT_EQ(material.transmission, 0.75f);
    EXPECT_NEAR(material.transmissionTexture.lookup({}).x, 0.8f, 1e-5f);
    EXPECT_EQ(material.ior, 1.5f);
    EXPECT_FALSE(material.isSolid);

    extensions["KHR_materials_ior"] = {{"ior", 1.25}};
    extensions["KHR_materials_volume"] = {
        {"thicknessFactor", 0.1}, {"attenuationDistance", 2}, {"attenuationColor", {0.5, 1, 0}}};
    material = materialOf(sceneOf(folder, gltf));
    EXPECT_EQ(material.ior, 1.25f);
    EXPECT_NEAR(material.specularF0, 1 / 81.0f, 1e-7f);
    EXPECT_TRUE(material.isSolid);
    EXPECT_NEAR(material.absorption.x, std::log(2.0f) / 2, 1e-6f);
    EXPECT_EQ(material.absorption.y, 0.0f);
    EXPECT_TRUE(material.absorption.z > 6 && std::isfinite(material.absorption.z));

    // A volume without a thickness is a sheet; an index of 0 is the name of what lets nothing pass.
    extensions["KHR_materials_volume"].erase("thicknessFactor");
    material = materialOf(sceneOf(folder, gltf));
    EXPECT_FALSE(material.isSolid);
    EXPECT_TRUE(isBlack(material.absorption));
    extensions["KHR_materials_ior"] = {{"ior", 0}};
    material = materialOf(sceneOf(folder, gltf));
    EXPECT_EQ(material.transmission, 0.0f);
    EXPECT_EQ(material.specularF0, 1.0f);
}

TEST(GltfMaterial, WebpPictures) {
    const TempFolder folder;
    writeRgba(folder, "a.webp", 1, std::vector<uint8_t>{255, 255, 255, 255});
    json gltf = withPicture("a.webp");
    gltf["images"].push_back({{"uri", "nowhere.png"}});
    gltf["textures"][0] = {{"source", 1}, {"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    gltf["extensionsUsed"] = json::array({"EXT_texture_webp"});
    const Scene scene = sceneOf(folder, gltf);
    ASSERT_TRUE(materialOf(scene).baseColorTexture);
    expectNear(materialOf(scene).baseColorTexture.lookup({}), Float3(1.0f), 0.01f);

    folder.write("a.webp", "no picture");
    gltf["textures"][0].erase("source");
    EXPECT_TRUE(
        hasNote(sceneOf(folder, gltf), "The texture 'a.webp' is left out: EXT_texture_webp: "));
}

TEST(GltfMaterial, PicturesInDataUris) {
    const TempFolder folder;
    const std::string bytes = bytesOf(writeColors(folder, "colors.png"));
    for (const char* type : {"image/png", "image/jpeg", "", "image/png;name=a"}) {
        const json gltf = withPicture("data:" + std::string(type) + ";base64," + base64(bytes));
        ASSERT_TRUE(materialOf(sceneOf(folder, gltf)).baseColorTexture) << type;
    }
    EXPECT_TRUE(hasNote(sceneOf(folder, withPicture("data:image/png;base64,%%%")),
                        "The texture 'image 0' is left out: its data is not encoded in base64."));
}

} // namespace
} // namespace wellstrat::render
