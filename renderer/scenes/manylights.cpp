// SPDX-License-Identifier: Apache-2.0
//
// Many small lights of very different power over a room with pillars: which light to sample is
// what matters.

#include "../framing.h"
#include "makers.h"
#include "parts.h"

#include "RixRNGInline.h"

#include <cmath>

namespace wellstrat::render {
namespace {

constexpr unsigned kLightsPerSide = 12;

/// Somewhere within the cell (i, j) of a square grid below the ceiling, hanging at some height.
/// Powers are log-uniform over a factor of 1000.
void addLight(Scene& scene, unsigned i, unsigned j) {
    const unsigned light = i * kLightsPerSide + j;
    const auto random = [&](unsigned what) { return HashToRandom(light, what); };
    const auto place = [&](unsigned cell, float offset) {
        return (static_cast<float>(cell) + 0.2f + 0.6f * offset) * (20.0f / kLightsPerSide) - 10;
    };
    const Float3 center(place(i, random(0)), 3.2f + 1.5f * random(1), place(j, random(2)));
    const float size = 0.06f + 0.1f * random(3);
    const float power = 0.006f * std::pow(1000.0f, random(4));
    const Float3 tint(0.6f + 0.4f * random(5), 0.6f + 0.4f * random(6), 0.6f + 0.4f * random(7));
    const uint32_t material = addMaterial(scene, emitter(tint * (power / (size * size))));
    if (light % 2 == 0)
        addQuads(scene, {rectangle(center, {size, 0, 0}, {0, 0, size})}, material);
    else
        scene.spheres.push_back({center, size / 2, material, {}});
}

} // namespace

Scene manyLightsScene() {
    Scene scene;
    const uint32_t gray = addMaterial(scene, lambertian(Float3(0.6f)));
    Material polished;
    polished.baseColor = Float3(0.45f, 0.4f, 0.35f);
    polished.roughness = 0.35f;
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 12}, {12, 0, 0})},
             addMaterial(scene, polished));
    addQuads(scene,
             {rectangle({0, 3, -12}, {12, 0, 0}, {0, 3, 0}),
              rectangle({-12, 3, 0}, {0, 0, -12}, {0, 3, 0}),
              rectangle({12, 3, 0}, {0, 0, 12}, {0, 3, 0}),
              rectangle({0, 6, 0}, {12, 0, 0}, {0, 0, 12})},
             gray);
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            addQuads(scene,
                     box({static_cast<float>(i) * 5, 1.2f, static_cast<float>(j) * 5 - 1},
                         {0.4f, 0, 0.2f}, {0, 1.2f, 0}, {-0.2f, 0, 0.4f}),
                     gray);
    for (unsigned i = 0; i < kLightsPerSide; ++i)
        for (unsigned j = 0; j < kLightsPerSide; ++j) addLight(scene, i, j);

    scene.camera = lookAt({3, 4.5f, 11.5f}, {-0.5f, 1.0f, 0}, {0, 1, 0}, radians(50));
    scene.aspect = 1.5f;
    return scene;
}

} // namespace wellstrat::render
