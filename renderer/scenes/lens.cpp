// SPDX-License-Identifier: Apache-2.0
//
// Depth of field and motion blur: rows of small objects before, in and behind the plane of focus,
// and two that move while the shutter is open. Most light comes from one direction, which takes no
// samples, so that lens and time are where the noise comes from.

#include "../framing.h"
#include "makers.h"
#include "parts.h"

namespace wellstrat::render {
namespace {

constexpr Float3 kPalette[] = {
    {0.8f, 0.25f, 0.2f}, {0.85f, 0.7f, 0.2f}, {0.25f, 0.6f, 0.35f}, {0.2f, 0.4f, 0.75f}};

Material metal(Float3 color) {
    Material material;
    material.baseColor = color;
    material.metallic = 1;
    material.roughness = 0.4f;
    return material;
}

/// A slanted row of spheres; every third one is of metal, with a highlight.
void addRow(Scene& scene, float x, float z) {
    for (unsigned i = 0; i < 12; ++i) {
        const auto step = static_cast<float>(i);
        const Float3 color = kPalette[i % 4];
        const bool isMetal = i % 3 == 2;
        const float radius = isMetal ? 0.14f : 0.22f;
        scene.spheres.push_back({{x + 0.28f * step, radius, z - 1.1f * step},
                                 radius,
                                 addMaterial(scene, isMetal ? metal(color) : lambertian(color)),
                                 {}});
    }
}

void addMovingSpheres(Scene& scene) {
    const uint32_t gold = addMaterial(scene, metal({0.9f, 0.75f, 0.5f}));
    const uint32_t yellow = addMaterial(scene, lambertian(kPalette[1]));
    scene.spheres.push_back({{-1.2f, 0.35f, 0.2f}, 0.35f, gold, Float3(-0.6f, 0.35f, 0.2f)});
    scene.spheres.push_back({{2.1f, 0.35f, 0.4f}, 0.3f, yellow, Float3(2.1f, 0.7f, 0.4f)});
}

PunctualLight sun() {
    PunctualLight light{};
    light.kind = PunctualLight::Kind::directional;
    light.direction = {0.5f, -1.0f, -0.4f};
    light.direction.Normalize();
    light.intensity = {2.4f, 2.2f, 1.9f};
    return light;
}

} // namespace

Scene lensScene() {
    Scene scene;
    Material ground = lambertian(Float3(1.0f));
    ground.baseColorTexture = checkerboard(24, 8, Float3(0.75f), Float3(0.12f));
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 16}, {16, 0, 0})}, addMaterial(scene, ground));
    addRow(scene, -3.2f, 5.0f);
    addRow(scene, -0.4f, 4.0f);
    addMovingSpheres(scene);

    scene.lights.push_back(sun());
    scene.environment = Environment{Float3(0.10f, 0.13f, 0.18f), nullptr};
    scene.camera = lookAt({0, 6, 8}, {0, 0.2f, 0.2f}, {0, 1, 0}, radians(32));
    scene.camera->lensRadius = 0.4f;
    scene.aspect = 1.5f;
    return scene;
}

} // namespace wellstrat::render
