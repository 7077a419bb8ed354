// SPDX-License-Identifier: Apache-2.0
//
// The textures of a scene file, each read once.

#pragma once

#include "../scene.h"
#include "notes.h"

#include <assimp/scene.h>

#include <map>
#include <string>
#include <utility>

namespace wellstrat::render {

/// How a texture's numbers are meant: colors of surfaces are decoded from sRGB and at most 1,
/// emitted colors are decoded from sRGB, data is what it is and at most 1.
enum class TextureUse { reflectance, emission, data };

class SceneTextures {
public:
    /// `folder` is that of the scene file, which relative paths start from.
    SceneTextures(const aiScene& scene, std::string folder, Notes& notes)
        : scene_(scene), folder_(std::move(folder)), notes_(notes) {}

    /// The texture that the scene calls `name`. Null, and a note, if it cannot be read.
    TexturePtr get(const std::string& name, TextureUse use);

private:
    Texture read(const std::string& name, Encoding encoding) const;

    const aiScene& scene_;
    std::string folder_;
    Notes& notes_;
    std::map<std::pair<std::string, TextureUse>, TexturePtr> known_;
};

} // namespace wellstrat::render
