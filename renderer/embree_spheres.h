// SPDX-License-Identifier: Apache-2.0
//
// Exact spheres for Embree, as a geometry of ours. (Embree's own round points skip the far side of
// a sphere for rays that begin near or in it, and compute in single precision.)

#pragma once

#include "scene.h"

#include <embree3/rtcore.h>

#include <limits>
#include <vector>

namespace wellstrat::render {

/// The context of a search for the closest hit. Embree's order of visits is its own affair and may
/// differ from run to run; this makes the result independent of it.
struct ClosestHit {
    RTCIntersectContext context; ///< first, so that callbacks find the rest
    float distance = std::numeric_limits<float>::infinity();
    uint32_t shape = 0;
    uint32_t primitive = 0;

    /// Takes a hit that is closer than the closest so far, or as close and earlier in the scene.
    /// Returns false, and changes nothing, for others.
    bool offer(float newDistance, uint32_t newShape, uint32_t newPrimitive) {
        const bool earlier = newShape < shape || (newShape == shape && newPrimitive < primitive);
        if (!(newDistance < distance || (newDistance == distance && earlier))) return false;
        distance = newDistance;
        shape = newShape;
        primitive = newPrimitive;
        return true;
    }
};

/// A geometry of all these spheres, which must outlive it. Closest hits need a ClosestHit context.
RTCGeometry makeSpheres(RTCDevice device, const std::vector<Sphere>& spheres);

} // namespace wellstrat::render
