// SPDX-License-Identifier: Apache-2.0
//
// The scene: a floor, a sphere over it, a rectangular light above both, a sky, a pinhole camera.
// Lengths are in any one unit, radiance in RGB; y is up.

#pragma once

#include "RiTypesHelper.h"

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
constexpr RtFloat3 kLightRadiance = {8.0f, 7.4f, 6.4f};

/// The ray through (x, y) of the image, [0, 1) from left to right and from top to bottom.
Ray cameraRay(RtFloat2 image);

/// The surface that the ray meets first. Returns false, and leaves `hit` alone, if there is none.
bool intersect(const Ray& ray, Hit& hit);

/// Whether the sphere is in the way of the ray between its origin and `distance`.
bool blocked(const Ray& ray, float distance);

/// Maps [0, 1)^2 to the light, uniformly in area.
LightPoint lightPoint(RtFloat2 xi);

/// What arrives along a ray that leaves a surface, of the sky alone: the sphere and the light hide
/// what is behind them.
RtFloat3 skyRadiance(const Ray& ray);

} // namespace area_light
