// SPDX-License-Identifier: Apache-2.0
//
// glTF files as such: where their parts are, which extensions they ask for, compressed parts.

#include "gltf_files.h"

#include <gtest/gtest.h>

namespace wellstrat::render {
namespace {

using nlohmann::json;

std::string reasonOf(const std::string& path) {
    const std::string error = errorOf(path);
    const std::size_t colon = error.find("': ");
    return colon == std::string::npos ? error : error.substr(colon + 3);
}

TEST(GltfDocument, BuffersOfAllSpellings) {
    const TempFolder folder;
    for (const char* name : {"my buffer.bin", "a+b.bin", "100%.bin", "caf\xc3\xa9.bin"})
        folder.write(name, quadBuffer());
    std::string percent;
    for (const char c : base64(quadBuffer()))
        percent += c == '+' ? "%2B" : c == '/' ? "%2f" : c == '=' ? "%3D" : std::string(1, c);
    for (const std::string& uri :
         {std::string("my buffer.bin"), std::string("my%20buffer.bin"), std::string("a+b.bin"),
          std::string("100%.bin"), std::string("caf%C3%A9.bin"), std::string("./my%20buffer.bin"),
          "data:application/octet-stream;base64," + base64(quadBuffer()),
          "data:application/gltf-buffer;base64," + base64(quadBuffer()),
          "data:;base64," + base64(quadBuffer()),
          "data:application/octet-stream;base64," + percent}) {
        json gltf = quadGltf();
        gltf["buffers"][0]["uri"] = uri;
        EXPECT_EQ(errorOf(folder.write("scene.gltf", gltf.dump())), "none") << uri;
    }
}

TEST(GltfDocument, MissingBuffersAreNamed) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["buffers"][0]["uri"] = "nowhere.bin";
    EXPECT_EQ(reasonOf(folder.write("scene.gltf", gltf.dump())),
              "buffer 0, 'nowhere.bin': no such file");
    gltf["buffers"][0]["uri"] = "data:application/octet-stream;base64,!";
    EXPECT_NE(reasonOf(folder.write("scene.gltf", gltf.dump())).find("not encoded in base64"),
              std::string::npos);
}

TEST(GltfDocument, OtherVersionsAreErrors) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["asset"]["version"] = "1.0";
    EXPECT_EQ(reasonOf(writeGltf(folder, gltf)), "it is of version 1.0 of glTF, not 2");
    gltf.erase("asset");
    EXPECT_EQ(reasonOf(writeGltf(folder, gltf)), "it does not say of which version of glTF it is");
}

TEST(GltfDocument, RequiredExtensionsThatAreNotReadAreErrors) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] =
        json::array({"KHR_texture_transform", "KHR_texture_basisu", "ACME_teapot"});
    EXPECT_EQ(reasonOf(writeGltf(folder, gltf)),
              "it requires KHR_texture_basisu and ACME_teapot, which cannot be read");
}

TEST(GltfDocument, UsedExtensionsThatAreNotReadGetALineEach) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] =
        json::array({"KHR_materials_clearcoat", "KHR_materials_unlit", "KHR_materials_sheen",
                     "KHR_materials_iridescence", "KHR_materials_anisotropy", "ACME_teapot"});
    const Scene scene = readScene(writeGltf(folder, gltf));
    for (const char* name : {"KHR_materials_clearcoat", "KHR_materials_sheen", "ACME_teapot",
                             "KHR_materials_iridescence", "KHR_materials_anisotropy"})
        EXPECT_TRUE(hasNote(scene, "What " + std::string(name) + " says is left out."));
    EXPECT_FALSE(hasNote(scene, "KHR_materials_unlit"));
}

TEST(GltfDocument, TexturesOfUnknownKindsAreNamed) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = json::array({"KHR_texture_basisu"});
    gltf["images"] = json::array({{{"uri", "a.ktx2"}}});
    gltf["textures"] = json::array({{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}});
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    EXPECT_TRUE(hasNote(readScene(writeGltf(folder, gltf)),
                        "Texture 0 is left out: KHR_texture_basisu cannot be read."));
}

TEST(GltfDocument, MeshoptThatCannotBeDecodedIsNamed) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] = json::array({"EXT_meshopt_compression"});
    const std::size_t compressed = addView(gltf, "no such stream");
    const std::size_t buffer = gltf["bufferViews"][compressed]["buffer"];
    auto& extension = gltf["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
    extension = {{"buffer", buffer},
                 {"byteLength", 14},
                 {"byteStride", 12},
                 {"count", 4},
                 {"mode", "ATTRIBUTES"}};
    EXPECT_EQ(reasonOf(writeGltf(folder, gltf)),
              "EXT_meshopt_compression: the data cannot be decoded");
    extension["mode"] = "ELSE";
    EXPECT_EQ(
        reasonOf(writeGltf(folder, gltf)),
        "EXT_meshopt_compression: its mode is not known, or does not fit its stride and count");
}

TEST(GltfDocument, DracoThatCannotBeDecodedIsNamed) {
    const TempFolder folder;
    json gltf = quadGltf();
    gltf["extensionsUsed"] = gltf["extensionsRequired"] =
        json::array({"KHR_draco_mesh_compression"});
    primitiveOf(gltf)["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", addView(gltf, "no such stream")}, {"attributes", {{"POSITION", 0}}}};
    EXPECT_EQ(reasonOf(writeGltf(folder, gltf)).rfind("KHR_draco_mesh_compression: ", 0), 0u);
}

} // namespace
} // namespace wellstrat::render
