// SPDX-License-Identifier: Apache-2.0
//
// Parts of glTF files for tests.

#pragma once

#include "scene_files.h"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace wellstrat::render {

inline std::string base64(const std::string& bytes) {
    constexpr auto kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (std::size_t j = i; j < i + 3; ++j)
            bits = bits << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
        for (unsigned j = 0; j < 4; ++j)
            text += i + j > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * j) & 63];
    }
    return text;
}

/// Adds a buffer and a view of all of it, and returns the number of the view.
inline std::size_t addView(nlohmann::json& gltf, const std::string& bytes) {
    gltf["bufferViews"].push_back(
        {{"buffer", gltf["buffers"].size()}, {"byteLength", bytes.size()}});
    gltf["buffers"].push_back({{"uri", "data:application/octet-stream;base64," + base64(bytes)},
                               {"byteLength", bytes.size()}});
    return gltf["bufferViews"].size() - 1;
}

template <typename T>
constexpr int componentType() {
    if (std::is_same_v<T, int8_t>) return 5120;
    if (std::is_same_v<T, uint8_t>) return 5121;
    if (std::is_same_v<T, int16_t>) return 5122;
    if (std::is_same_v<T, uint16_t>) return 5123;
    if (std::is_same_v<T, uint32_t>) return 5125;
    return 5126;
}

/// Adds an accessor of tightly packed values, and returns its number.
template <typename T>
std::size_t addAccessor(nlohmann::json& gltf, const std::vector<T>& values, const char* type,
                        std::size_t components, bool normalized = false) {
    std::string bytes;
    append<T>(bytes, values);
    gltf["accessors"].push_back({{"bufferView", addView(gltf, bytes)},
                                 {"componentType", componentType<T>()},
                                 {"count", values.size() / components},
                                 {"type", type},
                                 {"normalized", normalized}});
    return gltf["accessors"].size() - 1;
}

/// The only primitive of `quadGltf`.
inline nlohmann::json& primitiveOf(nlohmann::json& gltf) {
    return gltf["meshes"][0]["primitives"][0];
}

inline Material materialOf(const Scene& scene) {
    return scene.materials.at(scene.meshes.at(0).material);
}

} // namespace wellstrat::render
