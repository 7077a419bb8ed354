// SPDX-License-Identifier: Apache-2.0
//
// Rays, and the points of surfaces where they begin and end.

#pragma once

#include "wellstrat/vector.h"

#include <cstdint>
#include <limits>

namespace wellstrat::render {

struct Ray {
    Float3 origin;
    Float3 direction; ///< unit length
    float time = 0;   ///< in [0, 1], from the opening of the shutter to its closing
    float maxDistance = std::numeric_limits<float>::infinity();
    uint32_t chance = 0; ///< a random word, by which the ray passes what is not all there
};

/// A point of a surface, with a bound of how far rounding may have taken it off the surface.
struct SurfacePoint {
    Float3 position;
    Float3 normal; ///< geometric, unit length, as the shape was modeled
    float error;

    /// The point moved off the surface, to the side that `direction` points to, by just so much
    /// that a ray that begins there cannot hit what it leaves. Wächter and Binder 2019, "A Fast and
    /// Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, chapter 6, discuss the
    /// ways; the bound is of the kind of Pharr, Jakob and Humphreys, "Physically Based Rendering",
    /// section 6.8.
    Float3 offset(Float3 direction) const {
        return position + normal * (Dot(direction, normal) < 0.0f ? -error : error);
    }
};

/// A ray that leaves a surface.
inline Ray leave(const SurfacePoint& from, Float3 direction, float time) {
    return {from.offset(direction), direction, time};
}

/// The ray from one surface that ends just before another. They must not be the same point.
inline Ray connect(const SurfacePoint& from, const SurfacePoint& to, float time) {
    const Float3 origin = from.offset(to.position - from.position);
    Ray ray{origin, to.offset(origin - to.position) - origin, time};
    ray.maxDistance = ray.direction.Normalize() * (1.0f - 0x1p-20f);
    return ray;
}

} // namespace wellstrat::render
