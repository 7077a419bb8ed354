// SPDX-License-Identifier: Apache-2.0
//
// The textures of a scene of Assimp's, in files of their own or within it.

#pragma once

#include "file_textures.h"

#include <assimp/scene.h>

#include <string>

namespace wellstrat::render {

class SceneTextures : public FileTextures {
public:
    SceneTextures(const aiScene& scene, FileFinder& files, Notes& notes)
        : FileTextures(files, notes), scene_(scene) {}

private:
    Texture read(const std::string& name, TextureUse use) override;

    const aiScene& scene_;
};

} // namespace wellstrat::render
