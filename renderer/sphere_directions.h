// SPDX-License-Identifier: Apache-2.0
//
// Directions from a point to a sphere, all with about the same probability: Shirley et al. 1996,
// "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), section 3.2.

#pragma once

#include "wellstrat/warp.h"

namespace wellstrat::render {

/// How a point sees a sphere.
class SphereDirections {
public:
    /// `toCenter` leads from the point to the center of the sphere.
    SphereDirections(Float3 toCenter, float radius);

    /// Whether the point is in the sphere, which then is in all directions.
    bool inside() const { return inside_; }

    Float3 sample(Float2 xi) const;

    /// Per unit solid angle; for a direction that meets the sphere.
    float pdf(Float3 direction) const;

    /// How far away the sphere is in a direction that meets it, up to rounding.
    float distance(Float3 direction) const;

private:
    Float3 toCenter_, axis_;
    float radius_;
    bool inside_;
    float sinSquared_ = 0; ///< of half the angle that the sphere takes up
    float cosine_ = 0;     ///< of the same
};

} // namespace wellstrat::render
