// SPDX-License-Identifier: Apache-2.0
//
// Light that passes surfaces: thin sheets, and solid bodies that refract and absorb.

#include "bxdf_reference.h"
#include "rendering.h"

#include "renderer/bxdf.h"
#include "renderer/shapes.h"
#include "wellstrat/random_generator.h"

#include <RixRNG.h>

#include <memory>
#include <vector>

namespace wellstrat::render {
namespace {

using reference::kPi;

Material glass(float roughness, bool isSolid, float ior = 1.5f) {
    Material material;
    material.baseColor = Float3(1.0f);
    material.roughness = roughness;
    material.transmission = 1;
    material.isSolid = isSolid;
    material.ior = ior;
    return material;
}

Float3 directionAt(double angle, double turn = 0) {
    return {static_cast<float>(std::sin(angle) * std::cos(turn)),
            static_cast<float>(std::sin(angle) * std::sin(turn)),
            static_cast<float>(std::cos(angle))};
}

reference::Direction exact(Float3 v) { return {v.x, v.y, v.z}; }

Bxdf flatBxdf(const Material& m, Float3 view) {
    const Float3 normal(0, 0, 1);
    return {bxdfParameters(m, {}), normal, normal, view};
}

/// By the textbook, and the same both ways but for the squared index: from within and without.
TEST(Transmission, RefractsAsWalterSays) {
    const Material m = glass(0.6f, true);
    for (const double outAngle : {0.1, 0.8, 1.3, kPi - 0.3, kPi - 1.0}) {
        for (const double inAngle : {0.2, 0.7, 1.2}) {
            for (const double turn : {0.0, 2.0, 3.1}) {
                const Float3 out = directionAt(outAngle);
                const bool isInside = out.z < 0;
                const Float3 in = directionAt(isInside ? inAngle : kPi - inAngle, turn);
                const double eta = isInside ? 1.5 : 1 / 1.5;
                const double expected =
                    reference::refracted(m.roughness, eta, exact(in), exact(out));
                const double there = flatBxdf(m, out).evaluate(in).value.x / std::fabs(in.z);
                const double back = flatBxdf(m, in).evaluate(out).value.x / std::fabs(out.z);
                EXPECT_NEAR(there, expected, 2e-4 * expected + 1e-7);
                EXPECT_NEAR(there * eta * eta, back, 2e-4 * back + 1e-7);
            }
        }
    }
}

/// What a sheet lets pass is the mirror image of what a white metal with all of Fresnel's
/// reflection would reflect, times what is not reflected.
TEST(Transmission, SheetsLetPassTheMirrorImage) {
    Material mirror;
    mirror.baseColor = Float3(1.0f);
    mirror.metallic = 1;
    mirror.roughness = 0.5f;
    for (const double outAngle : {0.1, 0.8, 1.3}) {
        for (const double inAngle : {0.2, 0.7, 1.2}) {
            const Float3 out = directionAt(outAngle), in = directionAt(inAngle, 3);
            Float3 half = in + out;
            half.Normalize();
            const double passing = 1 - reference::fresnelReflection(1 / 1.5, Dot(out, half));
            const double expected = reference::specular(mirror, 0, exact(in), exact(out)) * passing;
            for (const float side : {1.0f, -1.0f}) {
                const Bxdf bxdf = flatBxdf(glass(0.5f, false), {out.x, out.y, side * out.z});
                const double value = bxdf.evaluate({in.x, in.y, -side * in.z}).value.x / in.z;
                EXPECT_NEAR(value, expected, 2e-4 * expected);
            }
        }
    }
}

/// The directions of the passing and of the reflected ray of a smooth surface, and their weights.
TEST(Transmission, SmoothBodiesFollowSnell) {
    for (const bool isInside : {false, true}) {
        const double eta = isInside ? 1.5 : 1 / 1.5;
        for (const double angle : {0.2, 0.6, 1.2}) {
            const Float3 view = directionAt(isInside ? kPi - angle : angle);
            const Bxdf bxdf = flatBxdf(glass(0, true), view);
            const double reflected = reference::fresnelReflection(eta, std::cos(angle));
            unsigned passed = 0, others = 0; // by far microfacets
            for (unsigned i = 0; i < 1024; ++i) {
                BxdfSample sample;
                if (!bxdf.sample(sample2D(5, i), sample)) continue;
                const bool passes = sample.direction.z * view.z < 0;
                EXPECT_EQ(bxdf.passes(sample.direction), passes);
                const double expected = -view.x * (passes ? eta : 1);
                if (std::fabs(sample.direction.x - expected) > 0.01) ++others;
                if (passes) ++passed;
                const double chance = std::fabs(passes ? 1 - reflected : reflected);
                EXPECT_LT(sample.weight.x, 1.1 + 0.1 / chance);
            }
            EXPECT_LT(others, 30u) << angle;
            EXPECT_NEAR(passed / 1024.0, 1 - reflected, 0.03) << angle;
        }
    }
}

/// A square of `material` across the y axis, seen from above or below at this angle, in even light.
Scene plate(const Material& material, double angle) {
    Scene scene;
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 1}, {1, 0, 0})}, addMaterial(scene, material));
    scene.environment.emplace();
    const Float3 eye(static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0);
    scene.camera = pointCamera(eye * 10, Float3(0.0f));
    return scene;
}

/// The sum over all directions of the textbook's values, which is what comes back of even light.
double sumOf(const Material& m, double angle) {
    const Float3 out = directionAt(angle);
    const Bxdf bxdf = flatBxdf(m, out);
    constexpr int kSide = 1500;
    double sum = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j)
            sum += bxdf.evaluate(squareToSphere({(static_cast<float>(i) + 0.5f) / kSide,
                                                 (static_cast<float>(j) + 0.5f) / kSide}))
                       .value.x;
    return sum * 4 * kPi / (kSide * kSide);
}

/// Samples have the mean of the values, which loses nothing but what scatters twice.
TEST(Transmission, PlatesPassWhatTheyDoNotReflect) {
    for (const bool isSolid : {false, true}) {
        for (const double angle : {0.1, 0.9, kPi - 0.5, kPi - 1.1}) {
            SCOPED_TRACE(angle);
            const Material m = glass(0.5f, isSolid);
            const double all = sumOf(m, angle);
            EXPECT_GT(all, 0.8);
            EXPECT_LT(all, 1.0001);
            expectMean(renderFilm(plate(m, angle), 32, 64), Float3(static_cast<float>(all)), 5e-3);
        }
    }
}

/// In a furnace, smooth bodies and sheets cannot be seen.
TEST(Transmission, SmoothGlassLosesNothing) {
    for (const bool isSolid : {true, false}) {
        Scene scene;
        scene.spheres.push_back({Float3(0.0f), 1, addMaterial(scene, glass(0, isSolid)), {}});
        scene.environment.emplace();
        scene.camera = lookAt({0, 0, 4}, Float3(0.0f), {0, 1, 0}, 0.4f);
        expectMean(renderFilm(scene, 32, 64, optionsOfDepth(100)), Float3(1.0f), 5e-3);
    }
}

/// A box of glass from y = -1 to 0.
void addBody(Scene& scene, const Material& material) {
    addQuads(scene, box({0, -0.5f, 0}, {5, 0, 0}, {0, 0.5f, 0}, {0, 0, 5}),
             addMaterial(scene, material));
}

/// Straight through a smooth slab: the sum over all reflections within.
TEST(Transmission, BodiesAbsorb) {
    Material m = glass(0, true);
    m.absorption = {0.5f, 1, 2};
    Scene scene;
    addBody(scene, m);
    scene.environment.emplace();
    scene.camera = pointCamera({0, 10, 0}, Float3(0.0f));
    Float3 expected;
    for (int c = 0; c < 3; ++c) {
        const double r = 0.04, left = std::exp(-double{m.absorption[c]});
        expected[c] = static_cast<float>(r + (1 - r) * (1 - r) * left / (1 - r * left));
    }
    expectMean(renderFilm(scene, 32, 256, optionsOfDepth(60)), expected, 5e-3);
}

TEST(Transmission, TintsByTheBaseColorAtEachSurface) {
    Material m = glass(0, true);
    m.baseColor = {0.5f, 0.7f, 1};
    Scene scene;
    addBody(scene, m);
    scene.environment.emplace();
    scene.camera = pointCamera({0, 10, 0}, Float3(0.0f));
    Float3 expected;
    for (int c = 0; c < 3; ++c) {
        const double r = 0.04, p = 0.96 * m.baseColor[c];
        expected[c] = static_cast<float>(r + p * p / (1 - r));
    }
    expectMean(renderFilm(scene, 32, 256, optionsOfDepth(60)), expected, 5e-3);
}

/// In amber that hardly refracts: what glows in it, and what it lights there.
TEST(Transmission, ThingsInBodiesAreSeenThroughThem) {
    Material amber = glass(0, true, 1);
    amber.absorption = {1, 2, 4};
    Scene scene;
    addBody(scene, amber);
    addQuads(scene, {rectangle({0, -0.5f, 0}, {0, 0, 1}, {1, 0, 0})},
             addMaterial(scene, emitter(Float3(1.0f))));
    scene.camera = pointCamera({0, 10, 0}, Float3(0.0f));
    expectMean(renderFilm(scene, 16, 16), {std::exp(-0.5f), std::exp(-1.0f), std::exp(-2.0f)},
               5e-3);
}

/// A lamp and a wall, with rough glass before and around them.
Scene glassScene(const Material& sheet, const Material& body) {
    Scene scene;
    addQuads(scene, {rectangle({0, -1, 0}, {0, 0, 3}, {3, 0, 0})},
             addMaterial(scene, lambertian({0.8f, 0.6f, 0.4f})));
    Material lamp = emitter({6, 5, 4});
    lamp.doubleSided = true;
    addQuads(scene, {rectangle({-1, 1.5f, 0}, {0.4f, 0, 0}, {0, 0, 0.4f})},
             addMaterial(scene, lamp));
    addQuads(scene, {rectangle({0.2f, 0.4f, 0.8f}, {0.6f, 0, 0}, {0, 0.6f, 0.2f})},
             addMaterial(scene, sheet));
    scene.spheres.push_back({{-0.8f, -0.3f, 0}, 0.6f, addMaterial(scene, body), {}});
    scene.camera = lookAt({0.5f, 1, 4}, {0, 0, 0}, {0, 1, 0}, 0.7f);
    return scene;
}

/// Found by chance or sampled, from outside and inside, light is as bright; and random samples have
/// the mean of stratified ones.
TEST(Transmission, AllStrategiesAndGeneratorsHaveOneMean) {
    Material body = glass(0.7f, true, 1.3f);
    body.absorption = {0.1f, 0.5f, 1};
    body.transmission = 0.7f;
    Material sheet = glass(0.6f, false);
    sheet.metallic = 0.2f;
    const Scene scene = glassScene(sheet, body);
    SamplingOptions options = optionsOfDepth(4);
    const Film both = renderFilm(scene, 32, 256, options);
    const RandomGenerator random;
    options.seed = 1;
    options.generator = &random;
    expectSameMean(both, renderFilm(scene, 32, 256, options));
    options.generator = nullptr;
    for (const Strategy strategy : {Strategy::lights, Strategy::bxdf}) {
        ++options.seed;
        options.strategy = strategy;
        expectSameMean(both, renderFilm(scene, 32, 256, options));
    }
}

} // namespace
} // namespace wellstrat::render
