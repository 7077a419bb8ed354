// SPDX-License-Identifier: Apache-2.0
//
// When a scene is dark, and the light that it gets.

#include "rendering.h"

#include "renderer/color.h"
#include "renderer/studio.h"

namespace wellstrat::render {
namespace {

/// A gray sphere before the camera.
Scene sphere() {
    Scene scene;
    scene.spheres.push_back({Float3(0.0f), 1, addMaterial(scene, lambertian(Float3(0.8f))), {}});
    scene.camera = lookAt({0, 0, 5}, Float3(0.0f), {0, 1, 0}, 0.6f);
    return scene;
}

void addLamp(Scene& scene, Float3 center, float size, float radiance) {
    Material lamp = emitter(Float3(radiance));
    lamp.doubleSided = true;
    addQuads(scene, {rectangle(center, {size, 0, 0}, {0, size, 0})}, addMaterial(scene, lamp));
}

TEST(LitShare, IsOfTheSurfacesThatAreSeen) {
    Scene scene = sphere();
    EXPECT_EQ(litShare(scene, 1), 0);
    Scene speck = scene;
    addLamp(speck, {0, 0, 1.001f}, 0.05f, 1);
    EXPECT_GT(litShare(speck, 1), 0);
    EXPECT_LT(litShare(speck, 1), kLeastLit);
    Scene lit = scene;
    addLamp(lit, {0, 0, 8}, 2, 5); // behind the camera
    EXPECT_GT(litShare(lit, 1), 0.9);
    EXPECT_EQ(litShare(lit, 1), litShare(lit, 1));
    scene.environment.emplace();
    EXPECT_EQ(litShare(scene, 1), 1); // although most of the picture is background
    scene.camera = lookAt({0, 0, 5}, {0, 0, 9}, {0, 1, 0}, 0.6f);
    EXPECT_EQ(litShare(scene, 1), 1); // nothing is seen
}

TEST(LitShare, OfASmallSun) {
    Scene scene = sphere();
    PunctualLight sun{};
    sun.kind = PunctualLight::Kind::directional;
    sun.direction = {1, 0, 0};
    sun.intensity = Float3(3.0f);
    scene.lights = {sun};
    EXPECT_NEAR(litShare(scene, 1), 0.5, 0.1);
}

TEST(Studio, IsNeutralGrayAndGradual) {
    const Environment light = studio({0, 0, -1});
    ASSERT_TRUE(light.map);
    for (const Float3 pixel : light.map->pixels()) {
        EXPECT_EQ(pixel, Float3(pixel.x));
        EXPECT_GE(pixel.x, 0.1f);
    }
    const Texture& map = *light.map;
    EXPECT_NEAR(map.pixel(0, map.height() - 1).x, 0.18f, 1e-3f); // the ground
    EXPECT_GT(map.pixel(map.width() / 2, 0).x, map.pixel(map.width() / 2, map.height() * 3 / 8).x);
}

/// From wherever one looks, white surfaces are bright but not burnt out, and the left is brighter.
TEST(Studio, ShowsScenesFromAllSides) {
    for (const Float3 forward : {Float3(0, 0, -1), Float3(1, 0, 0), Float3(-0.6f, 0, 0.8f)}) {
        Scene scene = sphere();
        scene.camera = lookAt(-forward * 5, Float3(0.0f), {0, 1, 0}, 0.3f);
        scene.environment = studio(forward);
        EXPECT_EQ(litShare(scene, 1), 1);
        const Film film = renderFilm(scene, 16, 64);
        const float left = luminance(film.mean(2, 8)), right = luminance(film.mean(13, 8));
        EXPECT_GT(left, 1.3f * right);
        EXPECT_GT(right, 0.1f);
        EXPECT_LT(left, 0.95f);
        const Estimate mean = channelMean(film, 0);
        EXPECT_GT(mean.mean, 0.25);
        EXPECT_LT(mean.mean, 0.75);
    }
}

} // namespace
} // namespace wellstrat::render
