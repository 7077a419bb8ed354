// SPDX-License-Identifier: Apache-2.0
//
// Cameras for scenes that come without.

#pragma once

#include "scene.h"

namespace wellstrat::render {

/// An axis-aligned box around something.
struct Bounds {
    Float3 low, high;

    Float3 center() const { return (low + high) * 0.5f; }
    /// Of the sphere around the box; not below the smallest normal float.
    float radius() const;
};

/// The box around all geometry of a scene, at all times of the shutter. The scene must have some.
Bounds sceneBounds(const Scene& scene);

/// A pinhole camera at `position` that sees `target` in the middle of the picture and `up` upward.
/// `verticalFov` is in radians. Throws std::invalid_argument if the three do not say where to look:
/// equal points, an `up` of length 0 or along the view, or anything that is not finite.
Camera lookAt(Float3 position, Float3 target, Float3 up, float verticalFov);

/// The same, looking in a direction of any length above 0, focused at distance 1.
Camera lookAlong(Float3 position, Float3 direction, Float3 up, float verticalFov);

/// `camera` carried around the axis through `center` by `degrees`, counterclockwise as seen from
/// the tip of `axis`. Whole turns change no bit. Throws std::invalid_argument for an axis that is 0
/// or not finite.
Camera turned(const Camera& camera, Float3 center, Float3 axis, double degrees);

/// A camera that sees all of the scene, as close as that goes in a picture of this width / height,
/// from the front (+z), a little from the right and above, as product pictures do. Focused on the
/// middle. The scene must have geometry.
Camera framingCamera(const Scene& scene, float aspect);

constexpr auto kNoCameraNote = "There is no camera: the picture shows the whole scene.";

/// Gives a scene without camera a `framingCamera` and `kNoCameraNote`. The scene must have
/// geometry.
void addMissingCamera(Scene& scene);

} // namespace wellstrat::render
