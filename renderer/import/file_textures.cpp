// SPDX-License-Identifier: Apache-2.0

#include "file_textures.h"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <new>

namespace wellstrat::render {

Texture FileTextures::read(const std::string& name, TextureUse use) {
    return readAs(use, files_.find(name));
}

TexturePtr FileTextures::get(const std::string& name, TextureUse use) {
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
