// SPDX-License-Identifier: Apache-2.0
//
// The textures of a scene file, each read once.

#pragma once

#include "../scene.h"
#include "notes.h"
#include "texture_use.h"

#include <assimp/scene.h>

#include <map>
#include <string>
#include <utility>

namespace wellstrat::render {

class SceneTextures {
public:
    /// `folder` is that of the scene file, which relative paths start from.
    SceneTextures(const aiScene& scene, std::string folder, Notes& notes)
        : scene_(scene), folder_(std::move(folder)), notes_(notes) {}

    /// The texture that the scene calls `name`. Null, and a note, if it cannot be read.
    TexturePtr get(const std::string& name, TextureUse use);

private:
    Texture read(const std::string& name, TextureUse use) const;

    const aiScene& scene_;
    std::string folder_;
    Notes& notes_;
    std::map<std::pair<std::string, TextureUse>, TexturePtr> known_;
};

} // namespace wellstrat::render
