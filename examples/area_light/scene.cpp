// SPDX-License-Identifier: Apache-2.0

#include "scene.h"

#include <cmath>
#include <limits>

namespace area_light {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kOffset = 1e-3f;

constexpr RtPoint3 kSphereCenter = {0.0f, 0.9f, 0.0f};
constexpr float kSphereRadius = 0.6f;
constexpr RtFloat3 kSphereAlbedo = {0.75f, 0.33f, 0.18f};
constexpr RtFloat3 kFloorAlbedo = {0.6f, 0.6f, 0.58f};

constexpr RtPoint3 kLightCorner = {-1.6f, 2.8f, -1.0f};
constexpr RtVector3 kLightEdgeU = {2.0f, 0.0f, 0.0f};
constexpr RtVector3 kLightEdgeV = {0.0f, 0.0f, 1.2f};
constexpr RtNormal3 kLightNormal = {0.0f, -1.0f, 0.0f};

constexpr RtFloat3 kHorizon = {0.22f, 0.26f, 0.32f};
constexpr RtFloat3 kZenith = {0.05f, 0.09f, 0.20f};

float sphereDistance(const Ray& ray) {
    const RtVector3 toCenter = kSphereCenter - ray.origin;
    const float along = toCenter.Dot(ray.direction);
    const float square = along * along - toCenter.LengthSq() + kSphereRadius * kSphereRadius;
    if (along < 0.0f || square < 0.0f) return kInfinity;
    return along - std::sqrt(square);
}

float floorDistance(const Ray& ray) {
    return ray.direction.y < 0.0f ? -ray.origin.y / ray.direction.y : kInfinity;
}

bool hitsLight(const Ray& ray) {
    if (ray.direction.y <= 0.0f) return false;
    const float distance = (kLightCorner.y - ray.origin.y) / ray.direction.y;
    const RtVector3 offset = ray.origin + ray.direction * distance - kLightCorner;
    return distance > 0.0f && offset.x >= 0.0f && offset.x < kLightEdgeU.x && offset.z >= 0.0f &&
           offset.z < kLightEdgeV.z;
}

} // namespace

Ray cameraRay(RtFloat2 image) {
    constexpr RtPoint3 kEye = {0.0f, 3.0f, 4.4f};
    constexpr RtPoint3 kTarget = {0.1f, 0.45f, 0.0f};
    constexpr float kHalfWidth = 0.38f; // of the image at distance 1
    RtVector3 forward = kTarget - kEye;
    forward.Normalize();
    RtVector3 right = forward.Cross({0.0f, 1.0f, 0.0f});
    right.Normalize();
    const RtVector3 down = forward.Cross(right);
    RtVector3 direction = forward + right * ((2.0f * image.x - 1.0f) * kHalfWidth) +
                          down * ((2.0f * image.y - 1.0f) * kHalfWidth);
    direction.Normalize();
    return {kEye, direction};
}

bool intersect(const Ray& ray, Hit& hit) {
    const float sphere = sphereDistance(ray);
    const float floor = floorDistance(ray);
    if (sphere < floor) {
        const RtPoint3 position = ray.origin + ray.direction * sphere;
        const RtNormal3 normal = (position - kSphereCenter) / kSphereRadius;
        hit = {position + normal * kOffset, normal, kSphereAlbedo};
    } else if (floor < kInfinity) {
        const RtNormal3 normal = {0.0f, 1.0f, 0.0f};
        hit = {ray.origin + ray.direction * floor + normal * kOffset, normal, kFloorAlbedo};
    }
    return sphere < kInfinity || floor < kInfinity;
}

bool blocked(const Ray& ray, float distance) { return sphereDistance(ray) < distance; }

LightPoint lightPoint(RtFloat2 xi) {
    return {kLightCorner + kLightEdgeU * xi.x + kLightEdgeV * xi.y, kLightNormal};
}

RtFloat3 skyRadiance(const Ray& ray) {
    if (ray.direction.y <= 0.0f || hitsLight(ray) || blocked(ray, kInfinity)) return RtFloat3(0.0f);
    return kHorizon + (kZenith - kHorizon) * ray.direction.y;
}

} // namespace area_light
