// SPDX-License-Identifier: Apache-2.0
//
// What the numbers of a picture mean.

#pragma once

#include "../texture.h"

#include <string>
#include <vector>

namespace wellstrat::render {

/// How a picture's numbers are meant: colors of surfaces are decoded from sRGB and at most 1,
/// emitted colors are decoded from sRGB, data is what it is and at most 1, of opacities the alpha
/// alone counts, as a gray that is 1 where the picture has none; coverage is the same, but the gray
/// of the picture where it has none.
enum class TextureUse { reflectance, emission, data, opacity, coverage };

/// `readTexture` for a use.
Texture readAs(TextureUse use, const std::string& path);
Texture readAs(TextureUse use, const std::vector<unsigned char>& bytes,
               const std::string& formatHint);

} // namespace wellstrat::render
