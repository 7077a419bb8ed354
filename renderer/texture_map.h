// SPDX-License-Identifier: Apache-2.0
//
// How materials find the color of a texture at a point of a surface.

#pragma once

#include "texture.h"

#include "wellstrat/vector.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace wellstrat::render {

using TexturePtr = std::shared_ptr<const Texture>;

/// What meshes tell from vertex to vertex, at one point of a surface.
struct SurfaceAttributes {
    Float2 uv{0, 0}, secondUv{0, 0}; ///< texture coordinates
    Float3 color{1, 1, 1};           ///< multiplies that of the material
    float opacity = 1;               ///< so does this
};

/// Maps (u, v) to u column `u` + v column `v` + offset.
struct UvTransform {
    Float2 u{1, 0}, v{0, 1}, offset{0, 0};

    Float2 operator()(Float2 uv) const {
        return {u.x * uv.x + v.x * uv.y + offset.x, u.y * uv.x + v.y * uv.y + offset.y};
    }
};

/// A texture, and where a material looks it up.
struct TextureMap {
    TextureMap() = default;
    TextureMap(TexturePtr itsTexture) : texture(std::move(itsTexture)) {}
    TextureMap(std::nullptr_t) {}

    explicit operator bool() const { return texture != nullptr; }

    /// Not of an empty map.
    Float3 lookup(const SurfaceAttributes& at) const {
        return texture->lookup(transform(takesSecondUv ? at.secondUv : at.uv), sampling);
    }

    TexturePtr texture; ///< null: none
    TextureSampling sampling;
    UvTransform transform;
    bool takesSecondUv = false; ///< the mesh's second texture coordinates, not the first
};

} // namespace wellstrat::render
