// SPDX-License-Identifier: Apache-2.0
//
// What must be done to glTF files before Assimp sees them.

#include "gltf_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace wellstrat::render {
namespace {

constexpr auto kExtension = "KHR_materials_emissive_strength";

// A .glb: glTF 2.0 specification, section 4.4. A header of three words (magic, version, length of
// the file), then chunks, each with a header of two words (length of its data, type); the first is
// the JSON.
constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;

/// 32 bits, least significant byte first.
std::size_t wordAt(const std::string& bytes, std::size_t offset) {
    std::size_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return word;
}

void setWord(std::string& bytes, std::size_t offset, std::size_t word) {
    for (std::size_t i = 0; i < 4; ++i) bytes[offset + i] = static_cast<char>(word >> 8 * i);
}

bool isBinary(const std::string& bytes) {
    return bytes.compare(0, 4, "glTF") == 0 && bytes.size() >= kFileHeader + kChunkHeader;
}

void requireAllOf(const std::string& bytes) {
    const std::size_t json = kFileHeader + kChunkHeader + wordAt(bytes, kFileHeader);
    if (bytes.size() < std::max(json, wordAt(bytes, 8)))
        throw std::runtime_error("the file is shorter than its header says");
}

std::string multiplied(const std::string& text) {
    auto json = nlohmann::json::parse(text);
    for (auto& material : json.at("materials")) {
        const float strength =
            material.value(nlohmann::json::json_pointer(std::string("/extensions/") + kExtension +
                                                        "/emissiveStrength"),
                           1.0f);
        if (!material.contains("emissiveFactor")) continue;
        for (auto& factor : material["emissiveFactor"]) factor = factor.get<float>() * strength;
    }
    return json.dump();
}

std::string multipliedBinary(const std::string& bytes) {
    const std::size_t begin = kFileHeader + kChunkHeader;
    const std::size_t length = wordAt(bytes, kFileHeader);
    std::string text = multiplied(bytes.substr(begin, length));
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string result = bytes.substr(0, begin) + text;
    if (bytes.size() > begin + length) result.append(bytes, begin + length, std::string::npos);
    setWord(result, kFileHeader, text.size());
    setWord(result, 8, result.size());
    return result;
}

} // namespace

std::optional<std::string> preparedGltf(const std::string& bytes) {
    if (isBinary(bytes)) requireAllOf(bytes);
    if (bytes.find(kExtension) == std::string::npos) return {};
    try {
        return isBinary(bytes) ? multipliedBinary(bytes) : multiplied(bytes);
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

} // namespace wellstrat::render
