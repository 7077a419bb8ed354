// SPDX-License-Identifier: Apache-2.0
//
// The textures that a scene file names, each read once for each use.

#pragma once

#include "../texture_map.h"
#include "files.h"
#include "notes.h"
#include "texture_use.h"

#include <map>
#include <string>
#include <utility>

namespace wellstrat::render {

class FileTextures {
public:
    FileTextures(FileFinder& files, Notes& notes) : files_(files), notes_(notes) {}
    virtual ~FileTextures() = default;
    FileTextures(const FileTextures&) = delete;
    FileTextures& operator=(const FileTextures&) = delete;

    /// The texture that the scene calls `name`. Null, and a note, if it cannot be read.
    TexturePtr get(const std::string& name, TextureUse use);

protected:
    virtual Texture read(const std::string& name, TextureUse use);

private:
    FileFinder& files_;
    Notes& notes_;
    std::map<std::pair<std::string, TextureUse>, TexturePtr> known_;
};

} // namespace wellstrat::render
