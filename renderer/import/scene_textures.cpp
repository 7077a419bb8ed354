// SPDX-License-Identifier: Apache-2.0
//
// The textures of a scene file, each read once.

#include "scene_textures.h"
#include "uris.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <vector>

namespace wellstrat::render {
namespace {

Texture readEmbedded(const aiTexture& texture, TextureUse use) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(texture.pcData);
    if (texture.mHeight > 0) throw std::runtime_error("embedded pixels are not supported");
    return readAs(use, std::vector<unsigned char>(bytes, bytes + texture.mWidth),
                  texture.achFormatHint);
}

} // namespace

Texture SceneTextures::read(const std::string& name, TextureUse use) const {
    if (const aiTexture* const embedded = scene_.GetEmbeddedTexture(name.c_str()))
        return readEmbedded(*embedded, use);
    return readAs(use, findFile(name, folder_));
}

TexturePtr SceneTextures::get(const std::string& name, TextureUse use) {
    const auto [entry, isNew] = known_.try_emplace({name, use});
    if (!isNew) return entry->second;
    try {
        entry->second = std::make_shared<const Texture>(read(name, use));
    } catch (const std::bad_alloc&) {
        throw; // without its textures the picture would be another one
    } catch (const std::exception& error) {
        notes_.add(fmt::format("The texture '{}' is left out: {}.", name, error.what()));
    }
    return entry->second;
}

} // namespace wellstrat::render
