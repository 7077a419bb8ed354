// SPDX-License-Identifier: Apache-2.0
//
// What rays hit: spheres, motion, ties, bad triangles, and rays that leave surfaces.

#include "renderer/geometry.h"

#include "renderer/scenes/parts.h"
#include "renderer/shapes.h"

#include <RixRNG.h>
#include <wellstrat/warp.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wellstrat::render {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Scene withMaterials(unsigned count) {
    Scene scene;
    for (unsigned i = 0; i < count; ++i) addMaterial(scene, lambertian(Float3(0.5f)));
    return scene;
}

float random(unsigned i, unsigned k) { return HashToRandom(i, k); }
Float3 randomDirection(unsigned i, unsigned k) {
    return squareToSphere({random(i, k), random(i, k + 1)});
}

TEST(Geometry, HitsSpheresFromWithinAndWithout) {
    Scene scene = withMaterials(1);
    scene.spheres = {{{0, 0, 0}, 1, 0, {}}, {{1000, 0, 0}, 999, 0, {}}, {{0, 3e6f, 0}, 1, 0, {}}};
    const Geometry geometry(scene);
    Hit hit;
    ASSERT_TRUE(geometry.closestHit({{0, 0, 5}, {0, 0, -1}}, hit));
    EXPECT_EQ(hit.shape, 0u);
    EXPECT_EQ(hit.primitive, 0u);
    EXPECT_FLOAT_EQ(hit.distance, 4);
    ASSERT_TRUE(geometry.closestHit({{0, 0, 0.5f}, {0, 0, -1}}, hit));
    EXPECT_FLOAT_EQ(hit.distance, 1.5f);
    // A tangent at a distance of 3e6 radii, which single precision could not tell from a miss.
    ASSERT_TRUE(geometry.closestHit({{0.999f, 2, 0}, {0, 1, 0}}, hit));
    EXPECT_EQ(hit.primitive, 2u);
    EXPECT_FALSE(geometry.closestHit({{0, 0, 5}, {0, 0, 1}}, hit));
    EXPECT_TRUE(geometry.occluded({{0, 0, 5}, {0, 0, -1}}));
    Ray shortRay{{0, 0, 5}, {0, 0, -1}};
    shortRay.maxDistance = 3.99f;
    EXPECT_FALSE(geometry.occluded(shortRay));
    EXPECT_FALSE(geometry.closestHit(shortRay, hit));
}

TEST(Geometry, ShapesMoveWithTheShutter) {
    Scene scene = withMaterials(1);
    addQuads(scene, {rectangle({-5, 0, 0}, {1, 0, 0}, {0, 1, 0})}, 0);
    for (const Float3 p : scene.meshes[0].positions) {
        scene.meshes[0].positionsAtEnd.push_back(p + Float3(10, 0, 0));
    }
    scene.spheres.push_back({{0, -5, 0}, 1, 0, Float3(0, 5, 0)});
    const Geometry geometry(scene);
    for (const float time : {0.0f, 0.25f, 0.5f, 1.0f}) {
        Hit hit;
        const Ray toQuad{{-5 + 10 * time + 0.5f, 0.7f, 9}, {0, 0, -1}, time};
        if (std::fabs(time - 0.5f) > 0.2f) {
            ASSERT_TRUE(geometry.closestHit(toQuad, hit)) << time;
            EXPECT_NEAR(geometry.surface(toQuad, hit).point.position.x, toQuad.origin.x, 1e-5);
        }
        const Ray toSphere{{0, -5 + 10 * time, 9}, {0, 0, -1}, time};
        ASSERT_TRUE(geometry.closestHit(toSphere, hit)) << time;
        EXPECT_EQ(hit.shape, 1u);
        EXPECT_FLOAT_EQ(hit.distance, 8);
        EXPECT_FLOAT_EQ(geometry.surface(toSphere, hit).point.position.z, 1);
    }
}

/// Guards against results that depend on the order in which Embree happens to visit shapes: of
/// many surfaces at the same place, the first is hit.
TEST(Geometry, TheFirstOfCoincidentShapesIsHit) {
    Scene scene = withMaterials(40);
    for (unsigned i = 0; i < 40; ++i) {
        Scene one = withMaterials(1);
        addQuads(one, {rectangle(Float3(0.0f), {1, 0, 0}, {0, 1, 0})}, i);
        scene.meshes.push_back(one.meshes[0]);
    }
    // and of the triangles of one mesh the first
    for (unsigned i = 0; i < 6; ++i) {
        scene.meshes[0].triangles.push_back(scene.meshes[0].triangles[i % 2]);
    }
    const Geometry geometry(scene);
    for (unsigned i = 0; i < 1000; ++i) {
        Hit hit;
        const Float2 at(2 * random(i, 0) - 1, 2 * random(i, 1) - 1);
        ASSERT_TRUE(geometry.closestHit({{at.x, at.y, 3}, {0, 0, -1}}, hit));
        EXPECT_EQ(hit.shape, 0u);
        EXPECT_LT(hit.primitive, 2u);
    }
    // Rays through the diagonal meet both triangles at exactly the same distance.
    for (const float at : {-0.5f, 0.0f, 0.25f}) {
        Hit hit;
        ASSERT_TRUE(geometry.closestHit({{at, at, 3}, {0, 0, -1}}, hit));
        EXPECT_EQ(hit.primitive, 0u);
    }
}

TEST(Geometry, BadTrianglesAreHarmless) {
    Scene scene = withMaterials(1);
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {kNan, 0, 0}, {1e30f, 0, 0}, {2, 0, 0}};
    const float infinity = std::numeric_limits<float>::infinity();
    mesh.positions.emplace_back(infinity, 0.0f, 0.0f);
    mesh.normals.assign(mesh.positions.size(), Float3(kNan));
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 0}, {0, 1, 5}, {0, 4, 2}, {0, 6, 2}};
    scene.meshes.push_back(mesh);
    const Geometry geometry(scene);
    unsigned hits = 0;
    for (unsigned i = 0; i < 20000; ++i) {
        const Ray ray{randomDirection(i, 0) * 2, randomDirection(i, 2)};
        Hit hit;
        if (!geometry.closestHit(ray, hit)) continue;
        ++hits;
        const Surface surface = geometry.surface(ray, hit);
        EXPECT_TRUE(std::isfinite(surface.point.position.LengthSq()));
        EXPECT_NEAR(surface.point.normal.Length(), 1, 1e-5);
        EXPECT_NEAR(surface.shadingNormal.Length(), 1, 1e-5);
    }
    EXPECT_GT(hits, 50u);
    Hit hit; // the good triangle is still there
    EXPECT_TRUE(geometry.closestHit({{0.25f, 0.25f, 1}, {0, 0, -1}}, hit));
}

TEST(Geometry, AnEmptySceneIsEmpty) {
    const Scene scene;
    const Geometry geometry(scene);
    Hit hit;
    EXPECT_FALSE(geometry.closestHit({{0, 0, 0}, {0, 0, 1}}, hit));
    EXPECT_FALSE(geometry.occluded({{0, 0, 0}, {0, 0, 1}}));
}

/// Guards against rays that hit the surface that they leave, and against rays that leak through
/// it: a ray from a point of a convex solid either leaves for good, or meets the other side.
void expectCleanDepartures(const Scene& scene, Float3 inside, float size) {
    const Geometry geometry(scene);
    unsigned bad = 0;
    for (unsigned i = 0; i < 50000; ++i) {
        const Ray ray{inside, randomDirection(i, 0)};
        Hit hit;
        if (!geometry.closestHit(ray, hit)) {
            ++bad;
            continue;
        }
        const SurfacePoint point = geometry.surface(ray, hit).point;
        // Half of the directions graze the surface.
        Float3 out = randomDirection(i, 2);
        if (i % 2) out += point.normal * (1e-3f * random(i, 4) - Dot(out, point.normal));
        out.Normalize();
        const float cosine = Dot(out, point.normal);
        if (cosine != 0 && geometry.occluded(leave(point, out, 0)) == (cosine > 0)) ++bad;
        // Between two points of the solid there is nothing; nor to a point outside.
        const Ray other{inside, randomDirection(i, 5)};
        if (!geometry.closestHit(other, hit)) continue;
        const SurfacePoint second = geometry.surface(other, hit).point;
        const Float3 across = second.position - point.position;
        if (across.Length() < 1e-3f * size) continue;
        if (geometry.occluded(connect(point, second, 0))) ++bad;
    }
    EXPECT_EQ(bad, 0u);
}

TEST(Geometry, RaysLeaveWhatTheyHit) {
    struct Place {
        Float3 center;
        float size;
    };
    for (const Place& place :
         {Place{{0, 0, 0}, 1}, Place{{100, -200, 300}, 1}, Place{{0, 0, 0}, 1e-4f},
          Place{{3, 1, 2}, 1e5f}, Place{{1000, 1000, 1000}, 20}}) {
        SCOPED_TRACE(place.size);
        Scene spheres = withMaterials(1);
        spheres.spheres.push_back({place.center, place.size, 0, {}});
        expectCleanDepartures(spheres, place.center + Float3(0.3f, 0.2f, 0.1f) * place.size,
                              place.size);
        Scene boxes = withMaterials(1);
        const Float3 u = Float3(0.8f, 0.6f, 0) * place.size;
        const Float3 v = Float3(-0.6f, 0.8f, 0) * place.size;
        addQuads(boxes, box(place.center, u, v, {0, 0, place.size}), 0);
        expectCleanDepartures(boxes, place.center + Float3(0.3f, 0.2f, 0.1f) * place.size,
                              place.size);
    }
}

} // namespace
} // namespace wellstrat::render
