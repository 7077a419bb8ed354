// SPDX-License-Identifier: Apache-2.0

#include "texture_use.h"
#include "../color.h"

#include <utility>

namespace wellstrat::render {
namespace {

Encoding encodingOf(TextureUse use) {
    return use == TextureUse::data ? Encoding::linear : Encoding::sRgb;
}

Channels channelsOf(TextureUse use) {
    switch (use) {
    case TextureUse::opacity: return Channels::alpha;
    case TextureUse::coverage: return Channels::alphaOrGray;
    default: return Channels::colors;
    }
}

/// Numbers above 1 are replaced by 1, where the use has none.
Texture inRange(TextureUse use, Texture texture) {
    if (use == TextureUse::emission) return texture;
    std::vector<Float3> pixels = texture.pixels();
    for (Float3& pixel : pixels) pixel = clamp01(pixel);
    return {texture.width(), texture.height(), std::move(pixels)};
}

} // namespace

Texture readAs(TextureUse use, const std::string& path) {
    return inRange(use, readTexture(path, encodingOf(use), channelsOf(use)));
}

Texture readAs(TextureUse use, const std::vector<unsigned char>& bytes,
               const std::string& formatHint) {
    return inRange(use, readTexture(bytes, formatHint, encodingOf(use), channelsOf(use)));
}

} // namespace wellstrat::render
