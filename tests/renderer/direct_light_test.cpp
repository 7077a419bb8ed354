// SPDX-License-Identifier: Apache-2.0
//
// Direct light against answers that owe nothing to the renderer: the closed form of a sphere over a
// plane, and quadrature over the light of the Cornell box. Each at single points of the scene.

#include "rendering.h"

#include "renderer/builtin_scenes.h"
#include "renderer/color.h"

namespace wellstrat::render {
namespace {

// --- A sphere over a plane; the closed form is in renderer/scenes/spherelight.cpp.

Float3 sphereLightAnswer(const Scene& scene, Float3 point) {
    const Sphere& sphere = scene.spheres[0];
    const Float3 toCenter = sphere.center - point;
    const float distance = toCenter.Length();
    const float factor =
        sphere.radius * sphere.radius * toCenter.y / (distance * distance * distance);
    return multiply(scene.materials[0].baseColor, scene.materials[sphere.material].emission) *
           factor;
}

TEST(DirectLight, OfASphereOverAPlaneIsTheClosedForm) {
    Scene scene = builtinScene("spherelight");
    for (const Float3 point : {Float3(0, 0, 0), Float3(0.5f, 0, 1), Float3(-2, 0, 3),
                               Float3(4, 0, -4), Float3(20, 0, 5)}) {
        SCOPED_TRACE(point.x);
        scene.camera = pointCamera({1, 1.2f, 7}, point);
        for (const Strategy strategy : {Strategy::both, Strategy::lights}) {
            SamplingOptions options = optionsOfDepth(3);
            options.strategy = strategy;
            expectMean(renderFilm(scene, 16, 64, options), sphereLightAnswer(scene, point), 2e-3);
        }
    }
    // bxdf samples alone find so small a light rarely
    scene.camera = pointCamera({1, 1.2f, 7}, {0, 0, 0.5f});
    SamplingOptions options = optionsOfDepth(0);
    options.strategy = Strategy::bxdf;
    expectMean(renderFilm(scene, 32, 256, options), sphereLightAnswer(scene, {0, 0, 0.5f}), 2e-2);
}

// --- The Cornell box

struct Double3 {
    double x, y, z;
};

Double3 wide(Float3 v) { return {v.x, v.y, v.z}; }
Double3 operator-(Double3 a, Double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Double3 operator+(Double3 a, Double3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Double3 operator*(Double3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(Double3 a, Double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Double3 cross(Double3 a, Double3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Corners {
    Double3 a, b, c;
    uint32_t material;
};

/// All triangles of a scene of meshes.
std::vector<Corners> trianglesOf(const Scene& scene) {
    std::vector<Corners> result;
    for (const Mesh& mesh : scene.meshes) {
        for (const auto& t : mesh.triangles) {
            result.push_back({wide(mesh.positions[t[0]]), wide(mesh.positions[t[1]]),
                              wide(mesh.positions[t[2]]), mesh.material});
        }
    }
    return result;
}

/// Where a ray meets a triangle, in units of `direction`, or a negative number. (Möller and
/// Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".)
double intersect(const Corners& t, Double3 origin, Double3 direction) {
    const Double3 p = cross(direction, t.c - t.a);
    const double determinant = dot(t.b - t.a, p);
    const double u = dot(origin - t.a, p) / determinant;
    const Double3 q = cross(origin - t.a, t.b - t.a);
    const double v = dot(direction, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return -1;
    return dot(t.c - t.a, q) / determinant;
}

/// The light that a point of the box sends back of what comes straight from the lamp: midpoints of
/// 300 x 300 cells of the lamp, each seen or not.
Float3 cornellAnswer(const Scene& scene, Float3 eye, Float3 target) {
    const std::vector<Corners> triangles = trianglesOf(scene);
    const Double3 view = wide(target) - wide(eye);
    const Corners* seen = nullptr;
    double closest = 1e30;
    for (const Corners& t : triangles) {
        const double distance = intersect(t, wide(eye), view);
        if (distance > 0 && distance < closest) {
            closest = distance;
            seen = &t;
        }
    }
    EXPECT_NE(seen, nullptr);
    if (!seen) return Float3(0.0f);
    const Double3 point = wide(eye) + view * closest;
    Double3 normal = cross(seen->b - seen->a, seen->c - seen->a);
    normal = normal * (1 / std::sqrt(dot(normal, normal)));

    Float3 emission(0.0f);
    double sum = 0;
    for (const Mesh& mesh : scene.meshes) {
        const Material& material = scene.materials[mesh.material];
        if (material.emission.x == 0) continue;
        emission = material.emission;
        const Double3 origin = wide(mesh.positions[0]);
        const Double3 u = wide(mesh.positions[1]) - origin;
        const Double3 v = wide(mesh.positions[3]) - origin;
        const Double3 areaNormal = cross(u, v); // its length is the area
        constexpr int kSide = 300;
        for (int i = 0; i < kSide * kSide; ++i) {
            const Double3 to =
                origin + u * ((i % kSide + 0.5) / kSide) + v * ((i / kSide + 0.5) / kSide) - point;
            const double distanceSq = dot(to, to);
            const double cosines = dot(to, normal) * -dot(to, areaNormal) / distanceSq;
            if (cosines <= 0) continue;
            bool blocked = false;
            for (const Corners& t : triangles) {
                const double distance = intersect(t, point, to);
                if (distance > 1e-6 && distance < 1 - 1e-6) blocked = true;
            }
            if (!blocked) sum += cosines / distanceSq / (kSide * kSide);
        }
    }
    const double factor = sum / 3.14159265358979323846;
    return multiply(scene.materials[seen->material].baseColor, emission) *
           static_cast<float>(factor);
}

TEST(DirectLight, OfTheCornellBoxIsThatOfQuadrature) {
    Scene scene = builtinScene("cornell");
    const Float3 eye(278, 273, -700);
    struct Place {
        const char* name;
        Float3 target;
    };
    for (const Place& place :
         {Place{"floor", {278, 0, 60}}, Place{"half shadow on the floor", {330, 0, 40}},
          Place{"half shadow of the tall block", {490, 0, 200}},
          Place{"left wall", {555, 200, 200}}, Place{"right wall", {0, 400, 300}},
          Place{"back wall", {200, 300, 559}}, Place{"top of the short block", {180, 165, 170}},
          Place{"front of the tall block", {350, 100, 271}}}) {
        SCOPED_TRACE(place.name);
        scene.camera = pointCamera(eye, place.target);
        const Float3 expected = cornellAnswer(scene, eye, place.target);
        ASSERT_GT(expected.x, 1e-4f);
        for (const Strategy strategy : {Strategy::both, Strategy::lights}) {
            SamplingOptions options = optionsOfDepth(0);
            options.strategy = strategy;
            expectMean(renderFilm(scene, 32, 256, options), expected, 3e-3);
        }
    }
}

} // namespace
} // namespace wellstrat::render
