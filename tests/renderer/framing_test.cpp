// SPDX-License-Identifier: Apache-2.0
//
// Cameras by look-at and by themselves.

#include "renderer/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace wellstrat::render {
namespace {

TEST(LookAt, PointsTheCamera) {
    const Camera camera = lookAt({1, 2, 3}, {1, 2, -7}, {0, 5, 1}, 0.5f);
    EXPECT_EQ(camera.forward, Float3(0, 0, -1));
    EXPECT_EQ(camera.up, Float3(0, 1, 0));
    EXPECT_EQ(camera.focusDistance, 10.0f);
    EXPECT_EQ(camera.lensRadius, 0.0f);
}

TEST(LookAt, WorksFarOutAndCloseUp) {
    for (const float scale : {1e-30f, 1e-10f, 1e10f, 1e30f}) {
        const Camera camera = lookAt(Float3(0.0f), {0, 0, scale}, {0, scale, 0}, 0.5f);
        EXPECT_EQ(camera.forward, Float3(0, 0, 1));
        EXPECT_EQ(camera.up, Float3(0, 1, 0));
    }
}

TEST(LookAt, RefusesWhatSaysNothing) {
    const Float3 eye(0, 0, 5), target(0.0f), up(0, 1, 0);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(lookAt(eye, eye, up, 0.5f), std::invalid_argument);
    EXPECT_THROW(lookAt(eye, target, {0, 0, 2}, 0.5f), std::invalid_argument);
    EXPECT_THROW(lookAt(eye, target, Float3(0.0f), 0.5f), std::invalid_argument);
    EXPECT_THROW(lookAt({nan, 0, 5}, target, up, 0.5f), std::invalid_argument);
    EXPECT_THROW(lookAt(eye, {0, nan, 0}, up, 0.5f), std::invalid_argument);
    for (const float fov : {0.0f, -1.0f, 3.15f, nan})
        EXPECT_THROW(lookAt(eye, target, up, fov), std::invalid_argument);
}

/// Whether a point lies within the picture.
bool isSeen(const Camera& camera, float aspect, Float3 point) {
    const Float3 to = point - camera.position;
    const float depth = Dot(to, camera.forward), half = std::tan(camera.verticalFov / 2) * depth;
    return depth > 0 && std::abs(Dot(to, camera.up)) <= half &&
           std::abs(Dot(to, Cross(camera.forward, camera.up))) <= half * aspect;
}

/// A quarter turn, seen from above, takes a camera in front of the scene to its right, and what it
/// showed of the axis stays where it is in the picture.
TEST(Turned, CarriesTheCameraAroundTheAxis) {
    Camera camera = lookAt({2, 3, 9}, {2, 1, 4}, {0, 1, 0}, 1);
    camera.lensRadius = 0.5f;
    const Float3 center(2, 0, 4);
    const Camera quarter = turned(camera, center, {0, 7, 0}, 90);
    const Camera expected = lookAt({7, 3, 4}, {2, 1, 4}, {0, 1, 0}, 1);
    EXPECT_LT((quarter.position - expected.position).Length(), 1e-5f);
    EXPECT_LT((quarter.forward - expected.forward).Length(), 1e-6f);
    EXPECT_LT((quarter.up - expected.up).Length(), 1e-6f);
    EXPECT_EQ(quarter.verticalFov, camera.verticalFov);
    EXPECT_EQ(quarter.lensRadius, camera.lensRadius);
    EXPECT_EQ(quarter.focusDistance, camera.focusDistance);
    const Camera back = turned(quarter, center, {0, -1, 0}, 90);
    EXPECT_LT((back.position - camera.position).Length(), 1e-5f);
    EXPECT_LT((back.forward - camera.forward).Length(), 1e-6f);
}

TEST(Turned, WholeTurnsChangeNothing) {
    const Camera camera = lookAt({0.1f, 0.2f, 0.3f}, {7, 1, 4}, {0, 1, 0}, 1);
    for (const double degrees : {0.0, 360.0, -720.0, 360e6}) {
        const Camera same = turned(camera, {3, 4, 5}, {1, 1, 0}, degrees);
        EXPECT_EQ(same.position, camera.position);
        EXPECT_EQ(same.forward, camera.forward);
        EXPECT_EQ(same.up, camera.up);
    }
}

TEST(Turned, RefusesNoAxis) {
    const Camera camera = lookAt({0, 0, 5}, Float3(0.0f), {0, 1, 0}, 1);
    EXPECT_THROW(turned(camera, Float3(0.0f), Float3(0.0f), 0), std::invalid_argument);
    EXPECT_THROW(turned(camera, Float3(0.0f), {std::nanf(""), 1, 0}, 3), std::invalid_argument);
}

/// The corners of a box.
Scene cornersOf(Float3 low, Float3 high) {
    Scene scene;
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back((corner & 1) ? high.x : low.x, (corner & 2) ? high.y : low.y,
                                    (corner & 4) ? high.z : low.z);
    scene.meshes.push_back(mesh);
    return scene;
}

TEST(Framing, ShowsAllOfTheScene) {
    for (const float aspect : {0.2f, 0.5f, 1.0f, 1.5f, 4.0f}) {
        for (const Float3 size :
             {Float3(1.0f), Float3(100, 0, 1), Float3(0, 1e-3f, 0), Float3(1e8f)}) {
            const Scene scene = cornersOf({3, -2, 1}, Float3(3, -2, 1) + size);
            const Camera camera = framingCamera(scene, aspect);
            for (const Float3 point : scene.meshes[0].positions)
                EXPECT_TRUE(isSeen(camera, aspect, point)) << aspect << ' ' << size.x;
        }
    }
}

/// A step of a 15th closer, something is cut off; and a sphere fills the picture on all sides.
TEST(Framing, IsTight) {
    for (const float aspect : {0.5f, 1.0f, 3.0f}) {
        const Scene scene = cornersOf({3, -2, 1}, {4, 5, 2});
        Camera camera = framingCamera(scene, aspect);
        camera.position += camera.forward * (camera.focusDistance / 15);
        unsigned seen = 0;
        for (const Float3 point : scene.meshes[0].positions)
            seen += isSeen(camera, aspect, point) ? 1 : 0;
        EXPECT_LT(seen, 8u) << aspect;
    }
    Scene scene;
    scene.spheres.push_back({{1, 2, 3}, 2, 0, {}});
    const Camera camera = framingCamera(scene, 1);
    const Float3 to = Float3(1, 2, 3) - camera.position;
    EXPECT_NEAR(Dot(to, camera.forward) / to.Length(), 1, 1e-5f);
    const float half = std::tan(std::asin(2 / to.Length())) / std::tan(camera.verticalFov / 2);
    EXPECT_NEAR(half, 1 / 1.04f, 1e-3f);
}

TEST(Framing, ASinglePointIsNoTrouble) {
    const Camera camera = framingCamera(cornersOf(Float3(7.0f), Float3(7.0f)), 1);
    EXPECT_TRUE(std::isfinite(camera.position.x));
    EXPECT_NEAR(camera.forward.Length(), 1.0f, 1e-6f);
}

TEST(Bounds, IncludeSpheresAndMotion) {
    Scene scene;
    scene.materials.emplace_back();
    scene.spheres.push_back({{0, 0, 0}, 1, 0, Float3(5, 0, 0)});
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 2, 0}, {0, 0, 1}};
    mesh.positionsAtEnd = {{0, 0, -9}, {0, 2, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    scene.meshes.push_back(mesh);
    const Bounds bounds = sceneBounds(scene);
    EXPECT_EQ(bounds.low, Float3(-1, -1, -9));
    EXPECT_EQ(bounds.high, Float3(6, 2, 1));
}

} // namespace
} // namespace wellstrat::render
