// SPDX-License-Identifier: Apache-2.0
//
// The camera and the pixel filter.

#include "renderer/camera.h"

#include "renderer/framing.h"
#include "renderer/pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wellstrat::render {
namespace {

Camera wideCamera() { return lookAt({1, 2, 3}, {1, 2, -7}, {0, 1, 0}, 1.0f); }

void expectNear(Float3 a, Float3 b, double tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance);
}

TEST(PictureCamera, SeesThePictureUprightAndUnmirrored) {
    const PictureCamera camera(wideCamera(), 200, 100);
    const Float2 middle(0.5f, 0.5f);
    expectNear(camera.ray({100, 50}, middle, 0).direction, {0, 0, -1}, 1e-6);
    const float half = std::tan(0.5f);
    const Float3 upperLeft = camera.ray({0, 0}, middle, 0).direction;
    EXPECT_NEAR(upperLeft.y / -upperLeft.z, half, 1e-5);
    EXPECT_NEAR(upperLeft.x / -upperLeft.z, -2 * half, 1e-5);
    const Ray ray = camera.ray({200, 100}, middle, 0.25f);
    EXPECT_NEAR(ray.direction.x / -ray.direction.z, 2 * half, 1e-5);
    EXPECT_EQ(ray.time, 0.25f);
    expectNear(ray.origin, {1, 2, 3}, 0);
}

TEST(PictureCamera, AllOfTheLensSeesThePlaneOfFocusSharply) {
    Camera thinLens = wideCamera();
    thinLens.lensRadius = 0.25f;
    thinLens.focusDistance = 4;
    const PictureCamera camera(thinLens, 64, 64);
    const PictureCamera pinhole(wideCamera(), 64, 64);
    double largest = 0;
    for (const Float2 lens : {Float2(0, 0), Float2(0.99f, 0.5f), Float2(0.2f, 0.9f)}) {
        const Ray sharp = pinhole.ray({10, 20}, lens, 0);
        const Ray ray = camera.ray({10, 20}, lens, 0);
        const auto inFocus = [](const Ray& r) {
            return r.origin + r.direction * (4 / -r.direction.z);
        };
        expectNear(inFocus(ray), inFocus(sharp), 1e-5);
        const Float3 offset = ray.origin - Float3(1, 2, 3);
        EXPECT_NEAR(offset.z, 0, 1e-6);
        EXPECT_LT(offset.Length(), 0.25001);
        largest = std::max(largest, double{offset.Length()});
    }
    EXPECT_GT(largest, 0.24);
}

TEST(PictureCamera, OrthographicRaysAreParallel) {
    Camera parallel = wideCamera();
    parallel.orthographicHeight = 3;
    const PictureCamera camera(parallel, 200, 100);
    const Float2 middle(0.5f, 0.5f);
    for (const Float2 place : {Float2(0, 0), Float2(200, 100), Float2(50, 75)}) {
        const Ray ray = camera.ray(place, middle, 0);
        expectNear(ray.direction, {0, 0, -1}, 1e-6);
        expectNear(ray.origin, {1 + (place.x - 100) * 0.03f, 2 - (place.y - 50) * 0.03f, 3}, 1e-5);
    }
    parallel.lensRadius = 0.25f;
    parallel.focusDistance = 4;
    const Ray ray = PictureCamera(parallel, 200, 100).ray({200, 50}, {0.9f, 0.3f}, 0);
    expectNear(ray.origin + ray.direction * (4 / -ray.direction.z), {4, 2, -1}, 1e-5);
    EXPECT_GT((ray.origin - Float3(4, 2, 3)).Length(), 0.1f);
}

/// The filter is the window: the fraction of samples left of x is the integral of the window up
/// to x, here by the midpoint rule.
TEST(PixelFilter, IsTheBlackmanHarrisWindow) {
    const PixelFilter filter;
    const auto window = [](double x) { // x in [0, 1]
        const double turn = 2 * 3.14159265358979323846 * x;
        return 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) -
               0.01168 * std::cos(3 * turn);
    };
    EXPECT_NEAR(filter.offset({0, 0.5f}).x, -PixelFilter::kRadius, 1e-6);
    EXPECT_NEAR(filter.offset({0, 0.5f}).y, 0, 1e-6);
    EXPECT_LT(filter.offset({1 - 0x1p-24f, 0}).x, PixelFilter::kRadius);
    double part = 0;
    constexpr int kSteps = 3000;
    for (int i = 0; i < kSteps; ++i) {
        const double x = (i + 0.5) / kSteps;
        part += window(x) / kSteps / 0.35875;
        if (part > 0.01 && part < 0.99) {
            const auto offset =
                static_cast<float>((2 * (x + 0.5 / kSteps) - 1) * PixelFilter::kRadius);
            EXPECT_NEAR(filter.offset({static_cast<float>(part), 0}).x, offset, 3e-3);
        }
    }
}

} // namespace
} // namespace wellstrat::render
