// SPDX-License-Identifier: Apache-2.0
//
// Cameras for scenes that come without.

#include "framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wellstrat::render {
namespace {

constexpr float kFramingFov = 0.6f; ///< radians, 34 degrees: a lens a little longer than normal
constexpr float kMargin = 1.04f;    ///< of the picture around the scene

void include(Bounds& bounds, Float3 point, float radius) {
    for (int c = 0; c < 3; ++c) {
        bounds.low[c] = std::min(bounds.low[c], point[c] - radius);
        bounds.high[c] = std::max(bounds.high[c], point[c] + radius);
    }
}

bool isFinite(Float3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// To length 1 without overflow or underflow on the way. False for 0 and what is not finite.
bool toUnitLength(Float3& v) {
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0f) || !isFinite(v)) return false;
    v /= largest;
    v.Normalize();
    return true;
}

/// Calls include(point) and include(center, radius) for all geometry, at all times of the shutter.
template <class Include>
void forEachPoint(const Scene& scene, const Include& include) {
    for (const Mesh& mesh : scene.meshes) {
        for (const Float3 p : mesh.positions) include(p);
        for (const Float3 p : mesh.positionsAtEnd) include(p);
    }
    for (const Sphere& sphere : scene.spheres) {
        include(sphere.center, sphere.radius);
        include(sphere.centerAtEnd.value_or(sphere.center), sphere.radius);
    }
}

/// What is to be seen along one axis of a picture whose half angle has this tangent. Points have a
/// place along the axis and a depth, both as seen from anywhere.
class Span {
public:
    explicit Span(float tangent) : tangent_(tangent) {}

    void include(float place, float depth, float radius) {
        // So far out is a tangent of the sphere that goes along the edge of the picture.
        const float reach = radius * std::sqrt(1 + tangent_ * tangent_);
        high_ = std::max(high_, place - depth * tangent_ + reach);
        low_ = std::max(low_, -place - depth * tangent_ + reach);
    }
    /// Where the camera sees all from the closest, and how far behind that is.
    float middle() const { return 0.5f * (high_ - low_); }
    float distance() const { return 0.5f * (high_ + low_) / tangent_; }

private:
    float tangent_;
    float high_ = -std::numeric_limits<float>::infinity(), low_ = high_;
};

} // namespace

float Bounds::radius() const {
    const Float3 half = high * 0.5f - low * 0.5f;
    return std::max(std::hypot(half.x, half.y, half.z), std::numeric_limits<float>::min());
}

Bounds sceneBounds(const Scene& scene) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Bounds bounds{Float3(kInfinity), Float3(-kInfinity)};
    forEachPoint(scene, [&](Float3 point, float radius = 0) { include(bounds, point, radius); });
    return bounds;
}

Camera lookAlong(Float3 position, Float3 direction, Float3 up, float verticalFov) {
    if (!(verticalFov > 0.0f && verticalFov < 3.14159f))
        throw std::invalid_argument(
            "a camera's field of view must be above 0 and below 180 degrees");
    if (!isFinite(position) || !toUnitLength(direction))
        throw std::invalid_argument("a camera must look at a point other than its own position");
    if (!toUnitLength(up))
        throw std::invalid_argument("a camera's up vector must have a length above 0");
    up -= direction * Dot(direction, up);
    if (up.LengthSq() < 1e-8f)
        throw std::invalid_argument("a camera's up vector must not lie along its view");
    up.Normalize();
    return {position, direction, up, verticalFov};
}

Camera lookAt(Float3 position, Float3 target, Float3 up, float verticalFov) {
    Camera camera = lookAlong(position, target - position, up, verticalFov);
    camera.focusDistance = Dot(target - position, camera.forward);
    return camera;
}

Camera turned(const Camera& camera, Float3 center, Float3 axis, double degrees) {
    if (!toUnitLength(axis))
        throw std::invalid_argument(
            "the axis that a camera turns about must have a length above 0");
    degrees = std::fmod(degrees, 360);
    if (degrees == 0) return camera;
    const double angle = degrees * (3.14159265358979323846 / 180);
    const auto cosine = static_cast<float>(std::cos(angle));
    const auto sine = static_cast<float>(std::sin(angle));
    const auto turn = [&](Float3 v) { // Rodrigues' formula
        return v * cosine + Cross(axis, v) * sine + axis * (Dot(axis, v) * (1 - cosine));
    };
    Camera result = camera;
    result.position = center + turn(camera.position - center);
    result.forward = turn(camera.forward);
    result.up = turn(camera.up);
    return result;
}

Camera framingCamera(const Scene& scene, float aspect) {
    const Float3 center = sceneBounds(scene).center();
    Camera camera = lookAlong(center, {-0.5f, -0.4f, -1.0f}, {0, 1, 0}, kFramingFov);
    const float tangent = std::tan(kFramingFov / 2) / kMargin;
    Span across(tangent * aspect), upward(tangent);
    const Float3 right = Cross(camera.forward, camera.up);
    const auto include = [&](Float3 point, float radius = 0) {
        const Float3 to = point - center;
        const float depth = Dot(to, camera.forward);
        across.include(Dot(to, right), depth, radius);
        upward.include(Dot(to, camera.up), depth, radius);
    };
    forEachPoint(scene, include);
    // A scene that is tiny for its place must not end up where the camera is.
    const float least = 4e-6f * center.Length() + std::numeric_limits<float>::min();
    camera.focusDistance = std::max({across.distance(), upward.distance(), least});
    camera.position += right * across.middle() + camera.up * upward.middle() -
                       camera.forward * camera.focusDistance;
    return camera;
}

void addMissingCamera(Scene& scene) {
    if (scene.camera) return;
    scene.camera = framingCamera(scene, scene.aspect);
    scene.cameraIsAutomatic = true;
    scene.notes.emplace_back(kNoCameraNote);
}

} // namespace wellstrat::render
