// SPDX-License-Identifier: Apache-2.0
//
// Where the shapes of a scene are at a time, 0 when the shutter opens and 1 when it closes, and
// points on them.

#pragma once

#include "color.h"
#include "ray.h"
#include "scene.h"

#include "wellstrat/warp.h"

namespace wellstrat::render {

struct Triangle {
    Float3 a, b, c;

    /// Along the geometric normal; its length is twice the area.
    Float3 areaNormal() const { return Cross(b - a, c - a); }
};

inline Triangle triangleAt(const Mesh& mesh, uint32_t primitive, float time) {
    const auto& corners = mesh.triangles[primitive];
    Float3 at[3];
    for (unsigned i = 0; i < 3; ++i) {
        at[i] = mesh.positions[corners[i]];
        if (!mesh.positionsAtEnd.empty()) {
            at[i] = lerp(at[i], mesh.positionsAtEnd[corners[i]], time);
        }
    }
    return {at[0], at[1], at[2]};
}

inline Float3 centerAt(const Sphere& sphere, float time) {
    return sphere.centerAtEnd ? lerp(sphere.center, *sphere.centerAtEnd, time) : sphere.center;
}

/// The value at the weights (u, v) of the second and the third corner.
template <class T>
T interpolate(const std::vector<T>& values, const std::array<uint32_t, 3>& corners, float u,
              float v) {
    return values[corners[0]] * (1.0f - u - v) + values[corners[1]] * u + values[corners[2]] * v;
}

/// The attributes at these weights; those of SurfaceAttributes itself where a mesh has none, and
/// for texture coordinates that are not finite.
SurfaceAttributes triangleAttributes(const Mesh& mesh, uint32_t primitive, float u, float v);

/// Texture coordinates of the point of a sphere with this normal: x turns around the y axis, y goes
/// down from the upper pole, evenly by area.
inline Float2 sphereUv(Float3 normal) {
    const Float2 square = sphereToSquare({normal.z, normal.x, normal.y});
    return {square.y, square.x};
}

/// `vector` with length 1, or `fallback` if it has no direction: if it is zero or not finite.
Float3 normalizedOr(Float3 vector, Float3 fallback);

/// `normal`, of unit length, tilted as the material's normal map says at `attributes`; as it is
/// where the mesh's texture coordinates give no direction, and where the map's is none.
Float3 mappedNormal(const Mesh& mesh, uint32_t primitive, const Triangle& triangle,
                    const Material& material, const SurfaceAttributes& attributes, Float3 normal);

/// The point with weights (u, v) of corners b and c. A triangle without a normal gets `fallback`.
SurfacePoint trianglePoint(const Triangle& triangle, float u, float v, Float3 fallback);

/// The point of the sphere that is nearest to `position`.
SurfacePoint spherePoint(const Sphere& sphere, Float3 position, float time);

} // namespace wellstrat::render
