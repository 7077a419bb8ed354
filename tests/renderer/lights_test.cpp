// SPDX-License-Identifier: Apache-2.0
//
// Light samples: their densities, against those of rays that meet the light by chance, and against
// solid angles; and the choice of a light.

#include "renderer/lights.h"

#include "renderer/discrete_distribution.h"
#include "renderer/environment.h"
#include "renderer/geometry.h"
#include "renderer/scenes/parts.h"
#include "statistical/statistics.h"

#include <RixRNG.h>
#include <RixShadingUtils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace wellstrat::render {
namespace {

Float2 random2D(unsigned i) { return randomSample2D(11, i); }

/// Lamps of all kinds, big and small, near and far, none hiding another from `receiver`.
Scene lamps() {
    Scene scene;
    const uint32_t oneSided = addMaterial(scene, emitter(Float3(3.0f)));
    Material both = emitter({1, 2, 5});
    both.doubleSided = true;
    const uint32_t doubleSided = addMaterial(scene, both);
    addQuads(scene, {rectangle({0, 0, 5}, {1, 0, 0}, {0, -2, 0})}, oneSided);
    addQuads(scene,
             {rectangle({0, 5, 0}, {3, 0.5f, 0}, {0, 0.2f, 1}),
              rectangle({-4, 0, 0}, {0.1f, 0, 1}, {0, 1, 0})},
             doubleSided);
    scene.spheres.push_back({{3, -2, 0}, 1, oneSided, {}});
    scene.spheres.push_back({{500, 100, 50}, 10, oneSided, {}});
    scene.spheres.push_back({{0, -4, -4}, 0.05f, doubleSided, Float3(0.5f, -4, -4)});
    return scene;
}

const SurfacePoint kReceiver{{0.1f, 0.2f, -0.1f}, {0, 0, 1}, 0};

/// Guards against the two ways to the same light having different densities, which would break
/// multiple importance sampling. At many times, for all lights.
TEST(Lights, DensityIsTheSameForSamplesAndForRays) {
    const Scene scene = lamps();
    const Geometry geometry(scene);
    const Lights lights(scene);
    unsigned compared = 0;
    for (unsigned i = 0; i < 20000; ++i) {
        const float time = randomSample1D(5, i);
        LightSample light;
        if (!lights.sample(kReceiver, time, random2D(i), light)) continue;
        EXPECT_NEAR(light.direction.Length(), 1, 1e-5);
        const Ray ray{kReceiver.position, light.direction, time};
        Hit hit;
        // A few graze the rim of their sphere so closely that they miss.
        if (!geometry.closestHit(ray, hit)) continue;
        const Surface surface = geometry.surface(ray, hit);
        if (std::fabs(Dot(surface.point.normal, light.direction)) < 0.01f) continue;
        ++compared;
        EXPECT_NEAR(lights.pdf(ray, hit, surface) / light.pdf, 1, 2e-3) << hit.shape;
        EXPECT_FALSE(geometry.occluded(light.shadowRay)) << i;
    }
    EXPECT_GT(compared, 19000u);
}

/// Guards against densities that do not sum to 1: the mean of 1 / pdf is the solid angle in which
/// there is light, here known from uniform directions.
TEST(Lights, DensityIsPerSolidAngle) {
    const Scene scene = lamps();
    const Geometry geometry(scene);
    const Lights lights(scene);
    constexpr unsigned kSamples = 400000;
    double bySamples = 0, squares = 0, byRays = 0;
    for (unsigned i = 0; i < kSamples; ++i) {
        LightSample light;
        if (lights.sample(kReceiver, 0, random2D(i), light)) {
            bySamples += 1 / light.pdf;
            squares += 1 / (double{light.pdf} * light.pdf);
        }
        const Ray ray{kReceiver.position, squareToSphere(randomSample2D(12, i))};
        Hit hit;
        if (geometry.closestHit(ray, hit)) byRays += 1;
    }
    const double mean = bySamples / kSamples;
    const double part = byRays / kSamples;
    const double solidAngle = 4 * double{F_PI} * part;
    const double variance = (squares / kSamples - mean * mean) / kSamples +
                            std::pow(4 * double{F_PI}, 2) * part * (1 - part) / kSamples;
    EXPECT_GE(statistical::normalTail((mean - solidAngle) / std::sqrt(variance)),
              statistical::kAlpha)
        << mean << " " << solidAngle;
    EXPECT_LT(std::sqrt(variance) / mean, 0.006);
}

/// Each sphere light alone: the mean of 1 / pdf is the solid angle of its cone, exactly, whether it
/// is treated as wide or as narrow; and from within, that of all directions.
TEST(Lights, SpheresFillTheirCones) {
    for (const float distance : {0.5f, 1.001f, 1.5f, 10.0f, 15.9f, 16.1f, 1000.0f, 1e5f}) {
        Scene scene;
        Material material = emitter(Float3(1.0f));
        material.doubleSided = true;
        addMaterial(scene, material);
        scene.spheres.push_back({{0, distance, 0}, 1, 0, {}});
        const Lights lights(scene);
        const double sine = 1 / double{distance};
        const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
        const double expected = 2 * double{F_PI} * (distance < 1 ? 2 : sine * sine / (1 + cosine));
        double sum = 0;
        constexpr unsigned kSide = 64;
        for (unsigned i = 0; i < kSide * kSide; ++i) {
            LightSample light;
            const Float2 xi((static_cast<float>(i % kSide) + 0.5f) / kSide,
                            (static_cast<float>(i / kSide) + 0.5f) / kSide);
            ASSERT_TRUE(lights.sample({Float3(0.0f), {0, 1, 0}, 0}, 0, xi, light)) << distance;
            sum += 1 / light.pdf;
            if (distance > 1) {
                EXPECT_GT(light.direction.y, cosine - 1e-6);
            }
        }
        EXPECT_NEAR(sum / (kSide * kSide) / expected, 1, 2e-5) << distance;
    }
}

TEST(Lights, PunctualLightsFollowTheirFormulas) {
    Scene scene;
    PunctualLight spot{};
    spot.kind = PunctualLight::Kind::spot;
    spot.position = {0, 2, 0};
    spot.direction = {0, -1, 0};
    spot.intensity = Float3(8.0f);
    spot.cosInner = 0.9f;
    spot.cosOuter = 0.5f;
    scene.lights.push_back(spot);
    const Lights lights(scene);
    LightSample light;
    ASSERT_TRUE(lights.sample({{0, 0, 0}, {0, 1, 0}, 0}, 0, {0.5f, 0.5f}, light));
    EXPECT_TRUE(light.punctual);
    EXPECT_FLOAT_EQ(light.pdf, 1);
    EXPECT_FLOAT_EQ(light.radiance.x, 8.0f / 4);
    EXPECT_FLOAT_EQ(light.direction.y, 1);
    EXPECT_NEAR(light.shadowRay.maxDistance, 2, 1e-5);
    // At a cosine of 0.7, half way between the cones, a quarter of the intensity is left.
    const float side = 2 * std::sqrt(1 - 0.49f) / 0.7f;
    ASSERT_TRUE(lights.sample({{side, 0, 0}, {0, 1, 0}, 0}, 0, {0.5f, 0.5f}, light));
    EXPECT_NEAR(light.radiance.x, 8.0f * 0.25f / (4 + side * side), 1e-5);
    EXPECT_FALSE(lights.sample({{9, 0, 0}, {0, 1, 0}, 0}, 0, {0.5f, 0.5f}, light));
}

TEST(Lights, ASceneWithoutLightHasNone) {
    Scene scene;
    addQuads(scene, {rectangle(Float3(0.0f), {1, 0, 0}, {0, 1, 0})},
             addMaterial(scene, lambertian(Float3(1.0f))));
    EXPECT_TRUE(Lights(scene).empty());
    scene.materials[0].emission = Float3(1.0f);
    EXPECT_FALSE(Lights(scene).empty());
}

TEST(DiscreteDistribution, ChoosesByWeightAndKeepsStrata) {
    const std::vector<double> weights{0, 3, 0, 1, 4, 0};
    const DiscreteDistribution distribution(weights);
    std::vector<unsigned> counts(weights.size(), 0);
    for (unsigned i = 0; i < 800; ++i) {
        float xi = (static_cast<float>(i) + 0.5f) / 800;
        const std::size_t chosen = distribution.choose(xi);
        ASSERT_LT(chosen, weights.size());
        // The samples of each choice are the strata of [0, 1) again, in order.
        EXPECT_NEAR(xi, (counts[chosen] + 0.5) / (100 * weights[chosen]), 1e-4);
        ++counts[chosen];
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_EQ(counts[i], 100 * weights[i]);
        EXPECT_DOUBLE_EQ(distribution.probability(i), weights[i] / 8);
    }
    for (float xi : {0.0f, 1 - 0x1p-24f}) {
        distribution.choose(xi);
        EXPECT_GE(xi, 0.0f);
        EXPECT_LT(xi, 1.0f);
    }
}

/// A map with a small sun, a black half and a bright pole.
Environment sunny() {
    constexpr unsigned kWidth = 32, kHeight = 16;
    std::vector<Float3> pixels(kWidth * kHeight, Float3(0.0f));
    for (unsigned i = 0; i < kWidth * kHeight / 2; ++i) pixels[i] = {0.2f, 0.5f, 1};
    for (unsigned i = 0; i < kWidth; ++i) pixels[i] = Float3(2.0f);
    pixels[5 * kWidth + 31] = Float3(500.0f); // at the seam
    Environment environment;
    environment.map = std::make_shared<Texture>(kWidth, kHeight, pixels);
    environment.radiance = {1, 1, 0.5f};
    return environment;
}

TEST(EnvironmentLight, LooksWhereTheMapSays) {
    std::vector<Float3> pixels;
    for (unsigned i = 0; i < 8; ++i) pixels.emplace_back(static_cast<float>(i));
    Environment environment;
    environment.map = std::make_shared<Texture>(4, 2, pixels);
    const EnvironmentLight light(environment);
    // The middle of the upper row's columns are at azimuths -3/4, -1/4, 1/4, 3/4 of pi from -z to
    // +x.
    const float r = std::sqrt(0.5f) * std::sqrt(0.5f);
    const float up = std::sqrt(0.5f);
    EXPECT_NEAR(light.radiance({-r, up, r}).x, 0, 1e-5);
    EXPECT_NEAR(light.radiance({-r, up, -r}).x, 1, 1e-5);
    EXPECT_NEAR(light.radiance({r, up, -r}).x, 2, 1e-5);
    EXPECT_NEAR(light.radiance({r, -up, r}).x, 7, 1e-5);
    EXPECT_NEAR(light.radiance({0, 0, -1}).x, 3.5f, 1e-5); // the very middle
}

/// A turn by the right hand about +y takes what is at -z to -x.
TEST(EnvironmentLight, IsTurned) {
    Environment environment = sunny();
    const EnvironmentLight straight(environment);
    for (const float rotation : {F_PIDIV2, F_PIDIV2 - 8 * F_PI}) {
        environment.rotation = rotation;
        const EnvironmentLight light(environment);
        for (unsigned i = 0; i < 100; ++i) {
            const Float3 d = squareToSphere(random2D(i));
            const Float3 back(-d.z, d.y, d.x);
            EXPECT_NEAR(light.radiance(d).y, straight.radiance(back).y, 0.01f) << i;
        }
    }
}

/// By multiples of the cells that the test sums over.
class TurnedEnvironment : public ::testing::TestWithParam<float> {};

INSTANTIATE_TEST_SUITE_P(EnvironmentLight, TurnedEnvironment,
                         ::testing::Values(0.0f, F_TWOPI * 37 / 512, F_TWOPI * -200 / 512));

/// Guards against an environment whose samples and density disagree, and one that leaves out light.
TEST_P(TurnedEnvironment, SamplesByItsDensity) {
    Environment environment = sunny();
    environment.rotation = GetParam();
    const EnvironmentLight light(environment);
    ASSERT_TRUE(light.canSample());
    constexpr unsigned kSide = 512;
    double mass = 0;
    double radiance = 0;
    for (unsigned i = 0; i < kSide * kSide; ++i) {
        const Float3 d = squareToSphere({(static_cast<float>(i % kSide) + 0.5f) / kSide,
                                         (static_cast<float>(i / kSide) + 0.5f) / kSide});
        mass += light.pdf(d);
        radiance += light.radiance(d).y;
        if (light.radiance(d).y > 0) {
            EXPECT_GT(light.pdf(d), 0);
        }
    }
    const double cell = 4 * double{F_PI} / (kSide * kSide);
    EXPECT_NEAR(mass * cell, 1, 2e-3);
    // The radiance over the sphere, by the light's own samples.
    double sum = 0, squares = 0;
    constexpr unsigned kSamples = 100000;
    for (unsigned i = 0; i < kSamples; ++i) {
        float pdf = 0;
        const Float3 d = light.sample(random2D(i), pdf);
        EXPECT_NEAR(d.Length(), 1, 1e-5);
        // At the edges of pixels the two may be of neighbors.
        if (i < 1000 && std::fabs(light.pdf(d) / pdf - 1) > 1e-3) {
            const Float3 near(d.x + 1e-5f, d.y, d.z + 1e-5f);
            EXPECT_NEAR(light.pdf(near) / pdf, 1, 1e-3) << i;
        }
        const double value = double{light.radiance(d).y} / pdf;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    EXPECT_NEAR(mean / (radiance * cell), 1, 6.2 * error / mean + 2e-3);
    EXPECT_LT(error / mean, 0.003);
}

TEST(EnvironmentLight, ConstantAndBlackOnesAreNotSampled) {
    EXPECT_FALSE(EnvironmentLight(Environment{}).canSample());
    Environment black;
    black.map = std::make_shared<Texture>(2, 1, std::vector<Float3>(2, Float3(0.0f)));
    const EnvironmentLight light(black);
    EXPECT_FALSE(light.canSample());
    EXPECT_EQ(light.pdf({0, 1, 0}), 0);
}

} // namespace
} // namespace wellstrat::render
