// SPDX-License-Identifier: Apache-2.0
//
// The scene: a floor, a sphere over it, a rectangular light above both, a sky, a pinhole camera.
// Lengths are in any one unit, radiance in RGB; y is up. Kernels of GPUs may call all of it.

#pragma once

#include "RiTypesHelper.h"

#include <cmath>
#include <limits>

namespace area_light {

struct Ray {
    RtPoint3 origin;
    RtVector3 direction; // length 1
};

/// A point of a surface that a ray has hit.
struct Hit {
    RtPoint3 position; // a little off the surface, so that new rays do not hit it again
    RtNormal3 normal;  // length 1
    RtFloat3 albedo;
};

/// A point of the light.
struct LightPoint {
    RtPoint3 position;
    RtNormal3 normal; // towards the lit side
};

constexpr float kLightArea = 2.0f * 1.2f;

namespace detail {

constexpr float kNever = std::numeric_limits<float>::infinity(); // a distance
constexpr float kOffset = 1e-3f;
constexpr float kSphereRadius = 0.6f;

// Functions, for device code has no constants of classes.
WELLSTRAT_HOST_DEVICE constexpr RtPoint3 sphereCenter() { return {0.0f, 0.9f, 0.0f}; }
WELLSTRAT_HOST_DEVICE constexpr RtPoint3 lightCorner() { return {-1.6f, 2.8f, -1.0f}; }
WELLSTRAT_HOST_DEVICE constexpr RtVector3 lightEdgeU() { return {2.0f, 0.0f, 0.0f}; }
WELLSTRAT_HOST_DEVICE constexpr RtVector3 lightEdgeV() { return {0.0f, 0.0f, 1.2f}; }

WELLSTRAT_HOST_DEVICE inline float sphereDistance(const Ray& ray) {
    const RtVector3 toCenter = sphereCenter() - ray.origin;
    const float along = toCenter.Dot(ray.direction);
    const float square = along * along - toCenter.LengthSq() + kSphereRadius * kSphereRadius;
    if (along < 0.0f || square < 0.0f) return kNever;
    return along - std::sqrt(square);
}

WELLSTRAT_HOST_DEVICE inline float floorDistance(const Ray& ray) {
    return ray.direction.y < 0.0f ? -ray.origin.y / ray.direction.y : kNever;
}

WELLSTRAT_HOST_DEVICE inline bool hitsLight(const Ray& ray) {
    if (ray.direction.y <= 0.0f) return false;
    const float distance = (lightCorner().y - ray.origin.y) / ray.direction.y;
    const RtVector3 offset = ray.origin + ray.direction * distance - lightCorner();
    return distance > 0.0f && offset.x >= 0.0f && offset.x < lightEdgeU().x && offset.z >= 0.0f &&
           offset.z < lightEdgeV().z;
}

} // namespace detail

WELLSTRAT_HOST_DEVICE constexpr RtFloat3 lightRadiance() { return {8.0f, 7.4f, 6.4f}; }

/// The ray through (x, y) of the image, [0, 1) from left to right and from top to bottom.
WELLSTRAT_HOST_DEVICE inline Ray cameraRay(RtFloat2 image) {
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

/// The surface that the ray meets first. Returns false, and leaves `hit` alone, if there is none.
WELLSTRAT_HOST_DEVICE inline bool intersect(const Ray& ray, Hit& hit) {
    using namespace detail;
    const float sphere = sphereDistance(ray);
    const float floor = floorDistance(ray);
    if (sphere < floor) {
        const RtPoint3 position = ray.origin + ray.direction * sphere;
        const RtNormal3 normal = (position - sphereCenter()) / kSphereRadius;
        hit = {position + normal * kOffset, normal, {0.75f, 0.33f, 0.18f}};
        return true;
    }
    if (floor == kNever) return false;
    const RtNormal3 normal = {0.0f, 1.0f, 0.0f};
    hit = {ray.origin + ray.direction * floor + normal * kOffset, normal, {0.6f, 0.6f, 0.58f}};
    return true;
}

/// Whether the sphere is in the way of the ray between its origin and `distance`.
WELLSTRAT_HOST_DEVICE inline bool blocked(const Ray& ray, float distance = detail::kNever) {
    return detail::sphereDistance(ray) < distance;
}

/// Maps [0, 1)^2 to the light, uniformly in area.
WELLSTRAT_HOST_DEVICE inline LightPoint lightPoint(RtFloat2 xi) {
    using namespace detail;
    return {lightCorner() + lightEdgeU() * xi.x + lightEdgeV() * xi.y, {0.0f, -1.0f, 0.0f}};
}

/// What arrives along a ray that leaves a surface, of the sky alone: the sphere and the light hide
/// what is behind them.
WELLSTRAT_HOST_DEVICE inline RtFloat3 skyRadiance(const Ray& ray) {
    constexpr RtFloat3 kHorizon = {0.22f, 0.26f, 0.32f};
    constexpr RtFloat3 kZenith = {0.05f, 0.09f, 0.20f};
    if (ray.direction.y <= 0.0f || detail::hitsLight(ray) || blocked(ray)) return RtFloat3(0.0f);
    return kHorizon + (kZenith - kHorizon) * ray.direction.y;
}

} // namespace area_light
