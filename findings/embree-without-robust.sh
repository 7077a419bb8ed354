#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# What Embree 3.13.5 (Debian 12: 3.13.5+dfsg-2) does without an error:
#
#     of rays that aim at points on inner edges of a height field of 8192 triangles without holes, about
#         one in five passes through (with isa=sse2 as with avx512): each of both triangles rounds by
#         itself. RTC_SCENE_FLAG_ROBUST closes it
#     a triangle of size 2e18 is left out: no ray meets it, and the bounds of its scene are empty
#     so is one with a coordinate that is NaN; those beside it are met
#
# The manual says of robust mode that it is "typically used for avoiding artifacts caused by rays shooting
# through edges of neighboring primitives", not how many do. Rays that aim at edges are not rare where
# lights, cameras or targets are on a grid.
#
# Needs g++ and what libembree-dev depends on.
#
# Expected: few leaks, as rounding makes them, one in thousands; rtcGetDeviceError tells what is left out.
# Found: as above, and no error.
# Versions: libembree3-3 3.13.5+dfsg-2. Source: Debian 12; the manual of Embree 3.13, "rtcSetSceneFlags".
# Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libembree-dev=3.13.5+dfsg-2 libembree3-3=3.13.5+dfsg-2
cat > main.cpp << 'END'
#include <embree3/rtcore.h>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>
struct Point { float x, y, z; };
struct Triangle { unsigned corners[3]; };
RTCDevice device;

RTCScene sceneOf(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                 RTCSceneFlags flags = RTC_SCENE_FLAG_NONE) {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, flags);
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* to = static_cast<Point*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Point), points.size()));
    for (const Point& point : points) *to++ = point;
    auto* next = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), triangles.size()));
    for (const Triangle& triangle : triangles) *next++ = triangle;
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene);
    return scene;
}

bool meets(RTCScene scene, Point from, Point to) {
    RTCRay ray{from.x, from.y, from.z, 0, to.x - from.x, to.y - from.y, to.z - from.z, 0,
               INFINITY, ~0u, 0, 0};
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
    return ray.tfar < 0;
}

/// The share of rays to inner edges that pass through a height field of 64 x 64 squares.
double leaks(RTCSceneFlags flags) {
    constexpr unsigned n = 64, row = n + 1;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    for (unsigned i = 0; i < row * row; ++i)
        points.push_back({i % row * 0.05f + 7, i / row * 0.05f + 7, 0.01f * unit(random)});
    for (unsigned y = 0; y < n; ++y)
        for (unsigned a = y * row; a < y * row + n; ++a) {
            triangles.push_back({{a, a + 1, a + row}});
            triangles.push_back({{a + 1, a + row + 1, a + row}});
        }
    RTCScene scene = sceneOf(points, triangles, flags);
    unsigned rays = 0, passed = 0;
    for (unsigned y = 1; y < n; ++y)
        for (unsigned x = 1; x + 1 < n; ++x)
            for (unsigned k = 0; k < 50; ++k, ++rays) {
                const Point a = points[y * row + x], b = points[y * row + x + 1];
                const float w = unit(random);
                const Point onEdge{a.x + w * (b.x - a.x), a.y + w * (b.y - a.y), a.z + w * (b.z - a.z)};
                const Point from{20 * unit(random) - 5, 20 * unit(random) - 5, -20};
                passed += !meets(scene, from, onEdge);
            }
    rtcReleaseScene(scene);
    return static_cast<double>(passed) / rays;
}

/// Is a triangle of that size, at distance 1 on the z axis, met?
bool isMet(float size) {
    RTCScene scene = sceneOf({{-size, -size, 1}, {size, -size, 1}, {0, size, 1}}, {{{0, 1, 2}}});
    RTCBounds bounds;
    rtcGetSceneBounds(scene, &bounds);
    const bool met = meets(scene, {0, 0, 0}, {0, 0, 1});
    std::printf("size %g: %s, bounds in x %g to %g\n", size, met ? "met" : "not met", bounds.lower_x,
                bounds.upper_x);
    rtcReleaseScene(scene);
    return met;
}

int main(int, char** arguments) {
    device = rtcNewDevice(arguments[1]); // null: the best instruction set
    const double usual = leaks(RTC_SCENE_FLAG_NONE), robust = leaks(RTC_SCENE_FLAG_ROBUST);
    std::printf("rays to edges that pass: %.3f, in robust mode %g\n", usual, robust);
    const bool ordinary = isMet(1e-10f) && isMet(1) && isMet(1e18f), huge = isMet(2e18f);
    const std::vector<Point> four{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}, {NAN, 0, 1}};
    const bool beside = meets(sceneOf(four, {{{0, 1, 3}}, {{0, 1, 2}}}), {0, 0, 0}, {0, 0, 1});
    const bool noError = rtcGetDeviceError(device) == RTC_ERROR_NONE;
    std::printf("beside NaN: %s, errors: %s\n", beside ? "met" : "not met", noError ? "none" : "some");
    return usual > 0.01 && robust == 0 && ordinary && !huge && beside && noError ? 0 : 1;
}
END
compile -O1 -lembree3
for configuration in "" isa=sse2; do
    ./main ${configuration:+"$configuration"} || changed "as printed above"
done
echo "as found"
