// SPDX-License-Identifier: Apache-2.0
//
// The textures of a scene file, each read once.

#include "scene_textures.h"
#include "../color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace wellstrat::render {
namespace {

namespace fs = std::filesystem;

int hexDigit(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (!std::isxdigit(byte)) return -1;
    return std::isdigit(byte) ? c - '0' : std::tolower(byte) - 'a' + 10;
}

/// With %20 and the like replaced by the bytes that they stand for: RFC 3986, section 2.1.
std::string percentDecoded(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        if (uri[i] == '%' && low >= 0) {
            text += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

/// The file that a scene means by `name`: files written under Windows have backslashes, those of
/// the web percent signs.
std::string findFile(const std::string& name, const std::string& folder) {
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    for (const std::string& spelling : {name, slashes, percentDecoded(slashes)}) {
        const fs::path path = fs::path(folder) / spelling;
        std::error_code ignored;
        if (fs::is_regular_file(path, ignored)) return path.string();
    }
    throw std::runtime_error("no such file");
}

Texture readEmbedded(const aiTexture& texture, Encoding encoding) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(texture.pcData);
    if (texture.mHeight > 0) throw std::runtime_error("embedded pixels are not supported");
    return readTexture(std::vector<unsigned char>(bytes, bytes + texture.mWidth),
                       texture.achFormatHint, encoding);
}

Texture clamped(const Texture& texture) {
    std::vector<Float3> pixels = texture.pixels();
    for (Float3& pixel : pixels) pixel = clamp01(pixel);
    return {texture.width(), texture.height(), std::move(pixels)};
}

} // namespace

Texture SceneTextures::read(const std::string& name, Encoding encoding) const {
    if (const aiTexture* const embedded = scene_.GetEmbeddedTexture(name.c_str()))
        return readEmbedded(*embedded, encoding);
    return readTexture(findFile(name, folder_), encoding);
}

TexturePtr SceneTextures::get(const std::string& name, TextureUse use) {
    const auto [entry, isNew] = known_.try_emplace({name, use});
    if (!isNew) return entry->second;
    try {
        Texture texture = read(name, use == TextureUse::data ? Encoding::linear : Encoding::sRgb);
        entry->second = std::make_shared<const Texture>(
            use == TextureUse::emission ? std::move(texture) : clamped(texture));
    } catch (const std::exception& error) {
        notes_.add(fmt::format("The texture '{}' is left out: {}.", name, error.what()));
    }
    return entry->second;
}

} // namespace wellstrat::render
