// SPDX-License-Identifier: Apache-2.0
//
// Small scene files for tests, and what tests ask of scenes.

#pragma once

#include "renderer/scene_file.h"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace wellstrat::render {

/// A folder that ends with the test.
class TempFolder {
public:
    TempFolder()
        : path_(std::filesystem::temp_directory_path() /
                ("wellstrat_" + std::to_string(::getpid()) + "_" +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
        std::filesystem::create_directories(path_);
    }
    ~TempFolder() { std::filesystem::remove_all(path_); }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }

    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& content) const {
        std::ofstream(path(name), std::ios::binary) << content;
        return path(name);
    }

private:
    std::filesystem::path path_;
};

template <typename T>
void append(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// The buffer of `quadGltf`: positions, normals, texture coordinates, indices.
inline std::string quadBuffer() {
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    append<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    append<float>(bytes, {0, 1, 1, 1, 1, 0, 0, 0});
    append<uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
    return bytes;
}

/// A unit square in the plane z = 0 that faces +z, of material 0, at node 0. Its texture
/// coordinates put a picture upright on it. The buffer is expected beside it, as quad.bin.
inline nlohmann::json quadGltf() {
    return nlohmann::json::parse(R"({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "quad"}],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
            "indices": 3, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 48},
            {"buffer": 0, "byteOffset": 96, "byteLength": 32},
            {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
        "buffers": [{"uri": "quad.bin", "byteLength": 140}]
    })");
}

/// Writes a glTF file and the buffer of `quadGltf`, and returns the path of the first.
inline std::string writeGltf(const TempFolder& folder, const nlohmann::json& gltf) {
    folder.write("quad.bin", quadBuffer());
    return folder.write("scene.gltf", gltf.dump());
}

/// The same as one binary file; `binary` is its buffer 0, which must have no "uri".
inline std::string glb(const nlohmann::json& gltf, std::string binary) {
    std::string json = gltf.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto size = [](std::size_t bytes) { return static_cast<uint32_t>(bytes); };
    std::string bytes = "glTF";
    append<uint32_t>(bytes, {2, size(28 + json.size() + binary.size()), size(json.size())});
    bytes += "JSON" + json;
    append<uint32_t>(bytes, {size(binary.size())});
    return bytes + std::string("BIN\0", 4) + binary;
}

inline void expectNear(Float3 a, Float3 b, float tolerance = 1e-5f) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance);
}

inline bool hasNote(const Scene& scene, const std::string& part) {
    return std::any_of(scene.notes.begin(), scene.notes.end(), [&](const std::string& note) {
        return note.find(part) != std::string::npos;
    });
}

inline std::string errorOf(const std::string& path) {
    try {
        readScene(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

/// Writes a picture of numbers in the order of pixels and returns its path.
template <typename T>
std::string writePicture(const TempFolder& folder, const std::string& name, int width, int height,
                         int channels, const std::vector<T>& values) {
    const std::string path = folder.path(name);
    const auto file = OIIO::ImageOutput::create(path);
    const OIIO::TypeDesc type(OIIO::BaseTypeFromC<T>::value);
    EXPECT_TRUE(file->open(path, OIIO::ImageSpec(width, height, channels, type)));
    EXPECT_TRUE(file->write_image(type, values.data()));
    EXPECT_TRUE(file->close());
    return path;
}

/// 2 x 2 pixels, upper row red and green, lower row blue and white.
inline std::string writeColors(const TempFolder& folder, const std::string& name) {
    return writePicture<uint8_t>(folder, name, 2, 2, 3,
                                 {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
}

inline std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The color of the base texture where the mesh has this position.
inline Float3 textureAt(const Scene& scene, const Mesh& mesh, Float3 position) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if ((mesh.positions[i] - position).Length() > 1e-5f) continue;
        // The middle of the pixel in that corner.
        const Float2 uv = mesh.uvs[i] * 0.5f + Float2(0.25f, 0.25f);
        return scene.materials[mesh.material].baseColorTexture.texture->lookup(uv);
    }
    ADD_FAILURE() << "no such vertex";
    return Float3(0.0f);
}

} // namespace wellstrat::render
