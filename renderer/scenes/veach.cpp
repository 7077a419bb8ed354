// SPDX-License-Identifier: Apache-2.0
//
// Glossy plates under sphere lights of the same power, after Veach 1997, "Robust Monte Carlo
// Methods for Light Transport Simulation", figure 9.2: where a light is small and the plate rough,
// sampling the light is right; where the light is large and the plate smooth, sampling the
// material. (The arrangement is his; the numbers are ours.)

#include "../framing.h"
#include "makers.h"
#include "parts.h"

#include <cmath>

namespace wellstrat::render {
namespace {

constexpr float kLightHeight = 5.0f, kLightDepth = -2.0f;
constexpr Float3 kEye(0, 4, 15);

/// A plate turned so that its middle mirrors the middle of the row of lights to the camera.
void addPlate(Scene& scene, Float3 center, float alpha) {
    Material plate;
    plate.baseColor = Float3(0.6f, 0.62f, 0.65f);
    plate.metallic = 1;
    plate.roughness = std::sqrt(alpha);

    Float3 toEye = kEye - center, toLights = Float3(0, kLightHeight, kLightDepth) - center;
    toEye.Normalize();
    toLights.Normalize();
    Float3 normal = toEye + toLights;
    normal.Normalize();
    const Float3 across(1, 0, 0), along = Cross(normal, across);
    addQuads(scene, box(center, across * 4.0f, normal * 0.06f, -along * 0.8f),
             addMaterial(scene, plate));
}

} // namespace

Scene veachScene() {
    Scene scene;
    const uint32_t wall = addMaterial(scene, lambertian(Float3(0.3f)));
    addQuads(scene,
             {rectangle({0, -1, 0}, {0, 0, 40}, {60, 0, 0}),
              rectangle({0, 30, -8}, {60, 0, 0}, {0, 31, 0})},
             wall);

    addPlate(scene, {0, 2.3f, 1.0f}, 0.004f);
    addPlate(scene, {0, 1.5f, 2.6f}, 0.015f);
    addPlate(scene, {0, 0.8f, 4.2f}, 0.05f);
    addPlate(scene, {0, 0.2f, 5.8f}, 0.12f);

    struct Light {
        float x, radius;
        Float3 color;
    };
    constexpr float kPower = 2.5f; ///< times 4 pi^2
    for (const Light& light :
         {Light{-4.2f, 0.04f, {1.0f, 0.55f, 0.4f}}, Light{-1.5f, 0.13f, {1.0f, 0.85f, 0.5f}},
          Light{1.4f, 0.4f, {0.6f, 1.0f, 0.6f}}, Light{4.6f, 1.0f, {0.5f, 0.7f, 1.0f}}})
        scene.spheres.push_back(
            {{light.x, kLightHeight, kLightDepth},
             light.radius,
             addMaterial(scene, emitter(light.color * (kPower / (light.radius * light.radius)))),
             {}});

    scene.camera = lookAt(kEye, {0, 2.2f, 2}, {0, 1, 0}, radians(36));
    scene.aspect = 1.5f;
    return scene;
}

} // namespace wellstrat::render
