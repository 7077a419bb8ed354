// SPDX-License-Identifier: Apache-2.0

#include "textures.h"
#include "values.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr auto kWebp = "EXT_texture_webp";

Wrap wrapOf(int mode) {
    switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return Wrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return Wrap::mirror;
    default: return Wrap::repeat;
    }
}

/// Pixels are looked at from near: the filter for that counts, and the other where it is alone.
bool isNearest(const tinygltf::Sampler& sampler) {
    const int filter = sampler.magFilter >= 0 ? sampler.magFilter : sampler.minFilter;
    return filter == TINYGLTF_TEXTURE_FILTER_NEAREST ||
           filter == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
           filter == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
}

/// The name extension of files of this type.
std::string formatHint(const std::string& mimeType) {
    const std::string_view kind = "image/";
    return mimeType.compare(0, kind.size(), kind) == 0 ? mimeType.substr(kind.size()) : "png";
}

Texture readImage(const GltfDocument& document, const ImageSource& source, TextureUse use) {
    if (!source.problem.empty()) throw std::runtime_error(source.problem);
    if (!source.uri.empty()) return readAs(use, document.files().find(source.uri));
    const std::string_view bytes =
        source.bufferView >= 0 ? document.bufferView(source.bufferView) : source.bytes;
    return readAs(use, std::vector<unsigned char>(bytes.begin(), bytes.end()),
                  formatHint(source.mimeType));
}

/// The names of the extensions that give a texture another picture.
std::string extensionsWithPictures(const tinygltf::Texture& texture) {
    std::string names;
    for (const auto& [name, value] : texture.extensions)
        if (value.Has("source")) names += (names.empty() ? "" : " or ") + name;
    return names;
}

} // namespace

TexturePtr GltfTextures::image(int number, TextureUse use) {
    const auto [entry, isNew] = known_.try_emplace({number, use});
    if (!isNew) return entry->second;
    try {
        const ImageSource& source = at(document_.images(), number, "image");
        entry->second = std::make_shared<const Texture>(readImage(document_, source, use));
    } catch (const std::bad_alloc&) {
        throw; // without its textures the picture would be another one
    } catch (const std::exception& error) {
        failed_[{number, use}] = error.what();
    }
    return entry->second;
}

TextureMap GltfTextures::get(int number, TextureUse use) {
    const auto& textures = document_.model().textures;
    if (number < 0 || static_cast<std::size_t>(number) >= textures.size()) {
        notes_.add(
            fmt::format("Texture {} is left out: the file has none of that number.", number));
        return {};
    }
    const tinygltf::Texture& texture = textures[static_cast<std::size_t>(number)];
    const tinygltf::Value* const webp = find(texture.extensions, kWebp);
    const int webpSource = webp ? indexOf(*webp, "source") : -1;

    TextureMap map;
    if (webpSource >= 0) map = image(webpSource, use);
    if (!map && texture.source >= 0) map = image(texture.source, use);
    if (map && texture.sampler >= 0) {
        const tinygltf::Sampler& sampler =
            at(document_.model().samplers, texture.sampler, "sampler");
        map.sampling = {wrapOf(sampler.wrapS), wrapOf(sampler.wrapT), isNearest(sampler)};
    }
    if (map) return map;

    const int source = texture.source >= 0 ? texture.source : webpSource;
    if (source < 0) {
        const std::string names = extensionsWithPictures(texture);
        notes_.add(names.empty()
                       ? fmt::format("Texture {} is left out: it has no picture.", number)
                       : fmt::format("Texture {} is left out: {} cannot be read.", number, names));
        return {};
    }
    const bool exists = static_cast<std::size_t>(source) < document_.images().size();
    notes_.add(fmt::format("The texture '{}' is left out: {}{}.",
                           exists ? document_.images()[static_cast<std::size_t>(source)].name
                                  : fmt::format("texture {}", number),
                           source == webpSource ? std::string(kWebp) + ": " : "",
                           failed_[{source, use}]));
    return {};
}

} // namespace wellstrat::render
