// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

/// Rounding in a position made from a shape's coordinates, and in the test of a ray against the
/// shape, is some 2^-24 of the coordinates; this is 16 times that.
constexpr float kRelativeError = 0x1p-20f;

float largestMagnitude(Float3 v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

} // namespace

Float3 normalizedOr(Float3 vector, Float3 fallback) {
    // In double precision no square of a float overflows or vanishes.
    const double x = vector.x;
    const double y = vector.y;
    const double z = vector.z;
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0.0) || !std::isfinite(length)) return fallback;
    const double scale = 1.0 / length;
    return {static_cast<float>(x * scale), static_cast<float>(y * scale),
            static_cast<float>(z * scale)};
}

SurfaceAttributes triangleAttributes(const Mesh& mesh, uint32_t primitive, float u, float v) {
    const auto uvOf = [&](const std::vector<Float2>& uvs) {
        if (uvs.empty()) return Float2(0.0f, 0.0f);
        const Float2 uv = interpolate(uvs, mesh.triangles[primitive], u, v);
        return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : Float2(0.0f, 0.0f);
    };
    SurfaceAttributes attributes;
    attributes.uv = uvOf(mesh.uvs);
    attributes.secondUv = uvOf(mesh.secondUvs);
    if (!mesh.colors.empty()) {
        const VertexColor color = interpolate(mesh.colors, mesh.triangles[primitive], u, v);
        attributes.color = color.color;
        attributes.opacity = color.opacity;
    }
    return attributes;
}

Float3 mappedNormal(const Mesh& mesh, uint32_t primitive, const Triangle& triangle,
                    const Material& material, const SurfaceAttributes& attributes, Float3 normal) {
    const auto& uvs = material.normalTexture.takesSecondUv ? mesh.secondUvs : mesh.uvs;
    if (uvs.empty()) return normal;
    const auto& corners = mesh.triangles[primitive];
    const Float2 b = uvs[corners[1]] - uvs[corners[0]], c = uvs[corners[2]] - uvs[corners[0]];
    const float area = b.x * c.y - b.y * c.x;
    const float sign = area < 0.0f ? -1.0f : 1.0f;
    // Along growing u, and across it on the side of falling v, on the tangent plane.
    Float3 tangent = ((triangle.b - triangle.a) * c.y - (triangle.c - triangle.a) * b.y) * sign;
    tangent = normalizedOr(tangent - normal * Dot(normal, tangent), Float3(0.0f));
    if (isBlack(tangent)) return normal;
    // The front is where u, -v and the normal are right-handed, unless the picture is mirrored.
    const Float3 bitangent = Cross(normal, tangent) * -sign;
    const Float3 color = material.normalTexture.lookup(attributes);
    const Float3 tilt = color * 2.0f - Float3(1.0f);
    return normalizedOr(tangent * (tilt.x * material.normalScale) +
                            bitangent * (tilt.y * material.normalScale) + normal * tilt.z,
                        normal);
}

SurfacePoint trianglePoint(const Triangle& triangle, float u, float v, Float3 fallback) {
    const Float3 a = triangle.a * (1.0f - u - v);
    const Float3 b = triangle.b * u;
    const Float3 c = triangle.c * v;
    const float size = largestMagnitude(a) + largestMagnitude(b) + largestMagnitude(c);
    return {a + b + c, normalizedOr(triangle.areaNormal(), fallback), kRelativeError * size};
}

SurfacePoint spherePoint(const Sphere& sphere, Float3 position, float time) {
    const Float3 center = centerAt(sphere, time);
    const Float3 normal = normalizedOr(position - center, Float3(0.0f, 0.0f, 1.0f));
    const float size = largestMagnitude(center) + sphere.radius;
    return {center + normal * sphere.radius, normal, kRelativeError * size};
}

} // namespace wellstrat::render
