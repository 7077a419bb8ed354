// SPDX-License-Identifier: Apache-2.0
//
// Material libraries of OBJ files.

#include "obj_files.h"

#include <gtest/gtest.h>

#include <string>

namespace wellstrat::render {
namespace {

Material materialOf(const Scene& scene) { return scene.materials[scene.meshes.at(0).material]; }

Material materialFrom(const std::string& text) {
    const TempFolder folder;
    return materialOf(readSquareObj(folder, text));
}

/// The color at coordinates of the file, from its lower left corner.
Float3 colorAt(const TextureMap& map, float u, float v) {
    SurfaceAttributes at;
    at.uv = {u, 1 - v};
    return map.lookup(at);
}

TEST(Mtl, OneNumberIsThatOfAllChannels) {
    expectNear(materialFrom("Kd 0.25\n").baseColor, Float3(0.25f));
}

TEST(Mtl, KeywordsInAnyCase) {
    expectNear(materialFrom("KD 0.1 0.2 0.3").baseColor, {0.1f, 0.2f, 0.3f});
}

TEST(Mtl, Opacity) {
    for (const char* const text :
         {"d 0.25", "Tr 0.75", "d 0.25\nTr 0.1", "Tr 0.1\nd 0.25", "d -halo 0.25"}) {
        const Material material = materialFrom(text);
        EXPECT_EQ(material.alpha, Material::Alpha::blend) << text;
        EXPECT_NEAR(material.opacity, 0.25f, 1e-6f) << text;
    }
    for (const char* const text : {"d 1", "Tr 0", "d 1\nTr 1", ""})
        EXPECT_EQ(materialFrom(text).alpha, Material::Alpha::opaque) << text;
}

TEST(Mtl, OpacityIsOfTheMaterialThatSaysIt) {
    EXPECT_NEAR(materialFrom("Tr 0.5\nnewmtl second\nd 0.1\n").opacity, 0.5f, 1e-6f);
}

// By the models of glass, straight on, and of refraction, whose equations do not know "d".
TEST(Mtl, LightThatPasses) {
    struct Case {
        const char* text;
        bool isSolid;
        float part, ior;
    };
    for (const Case& expected : {Case{"illum 4\nd 0.25\nKd 0 0 0\nKs 1 1 1\n", false, 0.75f, 1.5f},
                                 Case{"illum 9\nTr 1\nNi 1.3\n", false, 1, 1.3f},
                                 Case{"illum 7\nNi 1.8\nNs 10\nKs 1 1 1\n", true, 1, 1.8f},
                                 Case{"illum 6\nd 0.5\nNi 1.33\nTf 1\n", true, 0.5f, 1.33f},
                                 Case{"illum 7\nNi 0.5\nd 1\n", true, 1, 1}}) {
        const Material material = materialFrom(std::string("Kd 1 1 1\n") + expected.text);
        const bool isBlackBehind = expected.part == 0.75f;
        EXPECT_EQ(material.alpha, Material::Alpha::opaque) << expected.text;
        EXPECT_EQ(material.isSolid, expected.isSolid) << expected.text;
        EXPECT_NEAR(material.transmission, isBlackBehind ? 1 : expected.part, 1e-6f)
            << expected.text;
        expectNear(material.baseColor, Float3(isBlackBehind ? 0.75f : 1.0f));
        EXPECT_EQ(material.ior, expected.ior) << expected.text;
        EXPECT_EQ(material.roughness, 0.0f) << expected.text;
        EXPECT_EQ(material.metallic, 0.0f) << expected.text;
    }
}

// What passes and what is scattered have the colors Tf and Kd, together.
TEST(Mtl, ColorsOfLightThatPasses) {
    const Material clear = materialFrom("illum 7\nKd 0.5 0.5 0.5\nTf 0.9 0.5 0.1\n");
    expectNear(clear.baseColor, {0.9f, 0.5f, 0.1f});
    EXPECT_EQ(clear.transmission, 1.0f);
    const Material part = materialFrom("illum 7\nKd 0 1 0\nTf 1 0 0\nd 0.25\nPr 0.5\n");
    expectNear(part.baseColor, {0.75f, 0.25f, 0});
    EXPECT_NEAR(part.transmission, 0.75f * 0.2126f / (0.75f * 0.2126f + 0.25f * 0.7152f), 1e-6f);
    EXPECT_EQ(part.roughness, 0.5f);
}

// Opaque materials as Maya and 3ds Max write them, and blended ones as Blender does.
TEST(Mtl, LightThatDoesNotPass) {
    const TempFolder folder;
    for (const char* const text : {"illum 4\nTf 1.00 1.00 1.00\nNi 1.00\n", "illum 2\nTf 1 1 1\n",
                                   "illum 7\nTf 0 0 0\n", "illum 5\nd 1\n", "illum 1e99\n"}) {
        const Scene scene = readSquareObj(folder, text);
        EXPECT_EQ(materialOf(scene).transmission, 0.0f) << text;
        EXPECT_EQ(materialOf(scene).alpha, Material::Alpha::opaque) << text;
        EXPECT_EQ(scene.notes.size(), 1u) << text; // no camera
    }
    writePicture<uint8_t>(folder, "gray.png", 1, 1, 1, {102});
    for (const char* const text :
         {"illum 2\nd 0.5\n", "illum 9\nd 0.5\nTf 0 0 0\n", "illum 9\nd 0.5\nmap_d gray.png\n"}) {
        const Material material = materialOf(readSquareObj(folder, text));
        EXPECT_EQ(material.transmission, 0.0f) << text;
        EXPECT_EQ(material.alpha, Material::Alpha::blend) << text;
        EXPECT_EQ(material.opacity, 0.5f) << text;
    }
    EXPECT_TRUE(hasNote(readSquareObj(folder, "illum 4\nTf 0.2 0.2 0.2\n"), "'Tf'"));
    EXPECT_TRUE(hasNote(readSquareObj(folder, "illum 7\nNi 0.9\n"), "below 1 count as 1"));
}

// Alpha of the picture that "map_d" names, and of no other.
TEST(Mtl, OpacityOfPictures) {
    const TempFolder folder;
    writePicture<uint8_t>(folder, "alpha.png", 1, 1, 4, {255, 255, 255, 51});
    writePicture<uint8_t>(folder, "gray.png", 1, 1, 1, {102});
    Material material = materialOf(readSquareObj(folder, "map_Kd alpha.png\n"));
    EXPECT_EQ(material.alpha, Material::Alpha::opaque);
    expectNear(colorAt(material.baseColorTexture, 0, 0), Float3(1.0f));
    for (const auto& [name, opacity] :
         {std::pair("alpha.png", 0.2f), std::pair("gray.png", 0.4f)}) {
        material = materialOf(readSquareObj(folder, std::string("map_d ") + name + "\n"));
        EXPECT_EQ(material.alpha, Material::Alpha::blend);
        expectNear(colorAt(material.opacityTexture, 0, 0), Float3(opacity));
    }
}

// u' = 2 u + 0.25, v' = 2.7 v - 0.5, from the lower left corner; by numbers at many points.
TEST(Mtl, ScaleAndOffset) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    const auto mapOf = [&](const std::string& options) {
        return materialOf(readSquareObj(folder, "map_Kd " + options + " colors.png\n"))
            .baseColorTexture;
    };
    const TextureMap plain = mapOf("");
    expectNear(colorAt(plain, 0.25f, 0.75f), {1, 0, 0});
    for (const char* const options : {"-s 2 2.7 1 -o 0.25 -0.5 0", "-o 0.25 -0.5 -s 2 2.7"}) {
        const TextureMap map = mapOf(options);
        for (int i = 0; i < 25; ++i) {
            const float u = 0.21f * static_cast<float>(i % 5),
                        v = 0.17f * static_cast<float>(i / 5);
            expectNear(colorAt(map, u, v), colorAt(plain, 2 * u + 0.25f, 2.7f * v - 0.5f), 1e-4f);
        }
    }
    expectNear(colorAt(mapOf("-s 2"), 0.1f, 0.3f), colorAt(plain, 0.2f, 0.3f), 1e-4f);
}

TEST(Mtl, ClampedTexturesDoNotRepeat) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    for (const auto& [options, color] :
         {std::pair("-clamp on", Float3(0, 1, 0)), std::pair("-clamp off", Float3(1, 0, 0))}) {
        const Scene scene = readSquareObj(folder, std::string("map_Kd -blendu on ") + options +
                                                      " -s 1 colors.png\n");
        expectNear(colorAt(materialOf(scene).baseColorTexture, 1.25f, 0.75f), color);
    }
}

TEST(Mtl, NamesOfPictures) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("sub"));
    for (const char* const name : {"a b.png", "-1.png", "sub/c.png"}) writeColors(folder, name);
    for (const char* const name :
         {"a b.png", "\"a b.png\"", "a b.png # comment", "-s 1 1 1 -1.png", "sub\\c.png"}) {
        const Scene scene = readSquareObj(folder, std::string("map_Kd ") + name + "\n");
        EXPECT_TRUE(materialOf(scene).baseColorTexture) << name;
    }
}

// Relative to the scene, or else to the library.
TEST(Mtl, PicturesBesideTheLibrary) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("materials"));
    writeColors(folder, "materials/colors.png");
    folder.write("materials/a.mtl", "newmtl a\nmap_Kd colors.png\n");
    const Scene scene = readScene(folder.write(
        "scene.obj", "mtllib materials/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
    EXPECT_TRUE(materialOf(scene).baseColorTexture);
    EXPECT_EQ(scene.files.size(), 2u);
}

TEST(Mtl, MetallicRoughness) {
    const TempFolder folder;
    writePicture<uint8_t>(folder, "roughness.png", 1, 2, 1, {51, 102});
    writePicture<uint8_t>(folder, "metallic.png", 2, 1, 1, {153, 204});
    const Material numbers = materialOf(readSquareObj(folder, "Pr 0.3\nPm 0.7\nNi 1.5\n"));
    EXPECT_EQ(numbers.roughness, 0.3f);
    EXPECT_EQ(numbers.metallic, 0.7f);
    EXPECT_NEAR(numbers.specularF0, 0.04f, 1e-6f);
    const Material both =
        materialOf(readSquareObj(folder, "map_Pr roughness.png\nmap_Pm metallic.png\n"));
    EXPECT_EQ(both.roughness, 1.0f);
    EXPECT_EQ(both.metallic, 1.0f);
    const Texture& texture = *both.metallicRoughnessTexture.texture;
    EXPECT_NEAR(texture.pixel(0, 0).y, 0.2f, 1e-5f);
    EXPECT_NEAR(texture.pixel(1, 1).y, 0.4f, 1e-5f);
    EXPECT_NEAR(texture.pixel(0, 1).z, 0.6f, 1e-5f);
    EXPECT_NEAR(texture.pixel(1, 0).z, 0.8f, 1e-5f);
    const Material alone = materialOf(readSquareObj(folder, "Pm 0.5\nmap_Pr roughness.png\n"));
    EXPECT_NEAR(alone.metallicRoughnessTexture.texture->pixel(0, 0).z, 1.0f, 1e-6f);
    EXPECT_EQ(alone.metallic, 0.5f);
}

TEST(Mtl, NormalAndEmissionMaps) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    const Material material =
        materialOf(readSquareObj(folder, "norm -bm 0.5 colors.png\nmap_Ke colors.png\n"));
    expectNear(colorAt(material.normalTexture, 0.25f, 0.75f), {1, 0, 0});
    EXPECT_EQ(material.normalScale, 0.5f);
    expectNear(material.emission, Float3(1.0f));
    EXPECT_TRUE(material.emissionTexture);
}

TEST(Mtl, SaysWhatIsLeftOut) {
    const TempFolder folder;
    writeColors(folder, "colors.png");
    const Scene scene =
        readSquareObj(folder,
                      "Kd spectral steel.rfl\nKs 0.1 x\nNs many\nmap_Ks colors.png\n"
                      "bump colors.png\nmap_Kd -mm 0 2 -imfchan r colors.png\nPc 1\n");
    for (const char* const what : {"'Kd spectral steel.rfl'", "'Ns many'", "'map_Ks'", "'bump'",
                                   "'-mm'", "'-imfchan'", "'Pc'"})
        EXPECT_TRUE(hasNote(scene, what)) << what;
    EXPECT_TRUE(materialOf(scene).baseColorTexture);
    const Scene silent = readSquareObj(folder, "Ka 1 1 1\nillum 2\nNi 1\nPc 0\naniso 0.0\n");
    EXPECT_EQ(silent.notes.size(), 1u); // no camera
}

TEST(Mtl, NumbersOutOfRange) {
    const TempFolder folder;
    const Scene scene = readSquareObj(folder, "Kd 2 0.5 -1\nKe -1 nan 3\nd 7\n");
    expectNear(materialOf(scene).baseColor, {1, 0.5f, 0});
    EXPECT_EQ(materialOf(scene).alpha, Material::Alpha::opaque);
    EXPECT_TRUE(hasNote(scene, "outside [0, 1]"));
    EXPECT_TRUE(hasNote(scene, "'Ke -1 nan 3'"));
}

} // namespace
} // namespace wellstrat::render
