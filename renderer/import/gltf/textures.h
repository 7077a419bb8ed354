// SPDX-License-Identifier: Apache-2.0
//
// The textures of a glTF file, each picture read once for each use.

#pragma once

#include "../../texture_map.h"
#include "../notes.h"
#include "../texture_use.h"
#include "document.h"

#include <map>
#include <string>
#include <utility>

namespace wellstrat::render {

class GltfTextures {
public:
    GltfTextures(const GltfDocument& document, Notes& notes) : document_(document), notes_(notes) {}

    /// The texture of this number, looked up as its sampler says. Null, and a note, if there is
    /// none that can be read.
    TextureMap get(int texture, TextureUse use);

private:
    TexturePtr image(int image, TextureUse use);

    const GltfDocument& document_;
    Notes& notes_;
    std::map<std::pair<int, TextureUse>, TexturePtr> known_;
    std::map<std::pair<int, TextureUse>, std::string> failed_; ///< why
};

} // namespace wellstrat::render
