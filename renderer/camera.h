// SPDX-License-Identifier: Apache-2.0
//
// From a point of the picture, the lens and the shutter time to a camera ray.

#pragma once

#include "ray.h"
#include "scene.h"

namespace wellstrat::render {

/// The camera of a picture of width x height pixels. Immutable. Kolb et al. 1995, "A
/// Realistic Camera Model for Computer Graphics", section 3.1, has the thin lens.
class PictureCamera {
public:
    PictureCamera(const Camera& camera, unsigned width, unsigned height);

    /// The ray through `picture`, in pixels from the upper left corner, that leaves the lens at the
    /// point that `lens`, in [0, 1)^2, maps to. `time` is in [0, 1), from the opening of the
    /// shutter to its closing.
    Ray ray(Float2 picture, Float2 lens, float time) const;

private:
    Float3 position_;
    Float3 corner_, stepX_, stepY_; ///< of the plane of focus, as seen from the position
    bool isOrthographic_;
    Float3 toFocus_;       ///< from the position to the middle of the plane of focus
    Float3 lensX_, lensY_; ///< radii of the lens; 0 for a pinhole
};

} // namespace wellstrat::render
