// SPDX-License-Identifier: Apache-2.0

#include "scene_textures.h"

#include <stdexcept>
#include <vector>

namespace wellstrat::render {

Texture SceneTextures::read(const std::string& name, TextureUse use) {
    const aiTexture* const embedded = scene_.GetEmbeddedTexture(name.c_str());
    if (!embedded) return FileTextures::read(name, use);
    if (embedded->mHeight > 0) throw std::runtime_error("embedded pixels are not supported");
    const auto* const bytes = reinterpret_cast<const unsigned char*>(embedded->pcData);
    return readAs(use, std::vector<unsigned char>(bytes, bytes + embedded->mWidth),
                  embedded->achFormatHint);
}

} // namespace wellstrat::render
