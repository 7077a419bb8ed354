// SPDX-License-Identifier: Apache-2.0
//
// The path tracer has one mean, however its samples are drawn and weighted.

#include "rendering.h"

#include "renderer/builtin_scenes.h"
#include "renderer/film_error.h"
#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/random_generator.h"

#include <memory>
#include <string>

namespace wellstrat::render {
namespace {

constexpr unsigned kSide = 48;

/// Glossy and diffuse surfaces under a lamp, an emissive sphere, a point light, and a map with a
/// bright spot; some of it moves.
Scene everything() {
    Scene scene;
    Material glossy;
    glossy.baseColor = {0.9f, 0.7f, 0.4f};
    glossy.metallic = 0.7f;
    glossy.roughness = 0.5f;
    const uint32_t floor = addMaterial(scene, glossy);
    const uint32_t ball = addMaterial(scene, Material{});
    const uint32_t lamp = addMaterial(scene, emitter({8, 6, 4}));
    Material textured = emitter(Float3(4.0f));
    textured.emissionTexture = checkerboard(4, 1, {1, 0.2f, 0}, {0, 0.5f, 1});
    textured.doubleSided = true;
    const uint32_t screen = addMaterial(scene, textured);
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 3}, {3, 0, 0})}, floor);
    addQuads(scene, {rectangle({0, 3, 0}, {0.5f, 0, 0}, {0, 0, 0.5f})}, lamp);
    addQuads(scene, {rectangle({-2, 1, 0}, {0, 0, 1}, {0, 1, 0})}, screen);
    scene.spheres.push_back({{0.5f, 0.7f, 0.5f}, 0.6f, ball, Float3(0.9f, 0.7f, 0.5f)});
    scene.spheres.push_back({{1.5f, 0.4f, -1}, 0.3f, lamp, {}});
    std::vector<Float3> pixels(32, Float3(0.3f));
    pixels[9] = {20, 15, 10};
    scene.environment.emplace();
    scene.environment->map = std::make_shared<Texture>(8, 4, pixels);
    scene.camera = lookAt({1, 3, 5}, {0, 0.5f, 0}, {0, 1, 0}, 0.9f);
    scene.camera->lensRadius = 0.05f;
    scene.camera->focusDistance = 5;
    return scene;
}

TEST(Integrator, AllStrategiesHaveOneMean) {
    const Scene scene = everything();
    SamplingOptions options = optionsOfDepth(2);
    const Film both = renderFilm(scene, kSide, 256, options);
    options.seed = 1;
    options.strategy = Strategy::lights;
    const Film lights = renderFilm(scene, kSide, 256, options);
    options.seed = 2;
    options.strategy = Strategy::bxdf;
    const Film bxdf = renderFilm(scene, kSide, 256, options);
    expectSameMean(both, lights);
    expectSameMean(both, bxdf);
    expectSameMean(lights, bxdf);
}

TEST(Integrator, SplitAndDistributionKeepTheMean) {
    Scene scene = everything();
    PunctualLight point{};
    point.kind = PunctualLight::Kind::point;
    point.position = {-1, 2, 2};
    point.intensity = Float3(3.0f);
    scene.lights.push_back(point);
    for (const Strategy strategy : {Strategy::both, Strategy::lights}) {
        SamplingOptions options = optionsOfDepth(2);
        options.strategy = strategy;
        const Film plain = renderFilm(scene, kSide, 128, options);
        options.split = 3;
        options.seed = 1;
        const Film split = renderFilm(scene, kSide, 64, options);
        options.distrib = true;
        options.seed = 2;
        const Film distributed = renderFilm(scene, kSide, 64, options);
        expectSameMean(plain, split);
        expectSameMean(plain, distributed);
    }
}

/// Guards against samples that are only right for one generator: not uniform, or used twice in a
/// way that depends on their order.
TEST(Integrator, AllGeneratorsHaveOneMean) {
    const RandomGenerator random;
    const JointProgressive joint;
    for (const auto& info : builtinScenes()) {
        SCOPED_TRACE(info.name);
        const Scene scene = builtinScene(info.name);
        SamplingOptions options;
        const Film tables = renderFilm(scene, kSide, 64, options);
        options.generator = &random;
        const Film independent = renderFilm(scene, kSide, 64, options);
        expectSameMean(tables, independent);
        options.generator = &joint;
        options.seed = 1;
        expectSameMean(renderFilm(scene, kSide, 64, options), independent);
        const BlueProgressive blue;
        options.generator =
            &blue; // pixels are not independent, which makes the check a little milder
        expectSameMean(renderFilm(scene, kSide, 64, options), independent);
        options.generator = &joint;
        options.split = 3; // slots under splits have an order of their own
        options.seed = 2;
        expectSameMean(renderFilm(scene, kSide, 64, options), independent);
    }
}

/// Guards against losing what stratification is for, by using samples in the wrong order or place.
TEST(Integrator, TablesHaveLessError) {
    const RandomGenerator random;
    const Scene scene = builtinScene("spherelight");
    SamplingOptions options = optionsOfDepth(0);
    const auto error = [&](const Film& film, const Film& reference) {
        double sum = 0;
        for (unsigned y = 0; y < kSide; ++y)
            for (unsigned x = 0; x < kSide; ++x)
                sum += std::pow(film.mean(x, y).y - reference.mean(x, y).y, 2);
        return std::sqrt(sum);
    };
    options.seed = 1;
    const Film reference = renderFilm(scene, kSide, 1024, options);
    options.seed = 2;
    const Film tables = renderFilm(scene, kSide, 64, options);
    options.split = 4;
    const Film split = renderFilm(scene, kSide, 16, options);
    options.split = 1;
    options.generator = &random;
    const Film independent = renderFilm(scene, kSide, 64, options);
    EXPECT_LT(error(tables, reference), 0.5 * error(independent, reference));
    EXPECT_LT(error(split, reference), 0.7 * error(independent, reference));
}

/// Guards against slots that the path tracer loses on the way, or gives to nothing that matters:
/// the error of one picture is that between two, up to a factor that both have.
TEST(Integrator, SlotsHaveLessErrorThanTables) {
    const JointProgressive joint;
    const Scene scene = builtinScene("spherelight");
    for (const unsigned split : {1u, 2u}) {
        const auto difference = [&](const Generator* generator) {
            SamplingOptions options = optionsOfDepth(0);
            options.generator = generator;
            options.split = split;
            const Film one = renderFilm(scene, 24, 1024, options);
            options.seed = 1;
            return filmError(one, renderFilm(scene, 24, 1024, options)).rmse;
        };
        EXPECT_LT(difference(&joint), 0.75 * difference(nullptr)) << "split " << split;
    }
}

/// Guards against losing what pixels know of each other: by contexts that are not the generator's,
/// or derived without it.
TEST(Integrator, BlueErrorsCancelBetweenNeighbors) {
    const BlueProgressive blue;
    const Scene scene = builtinScene("spherelight");
    SamplingOptions options = optionsOfDepth(0);
    const Film reference = renderFilm(scene, kSide, 1024, options);
    constexpr unsigned kBlock = 8;
    const auto blockError = [&](const Generator* generator, unsigned samples) {
        double squares = 0;
        options.generator = generator;
        for (options.seed = 1; options.seed < 9; ++options.seed) {
            const Film film = renderFilm(scene, kSide, samples, options);
            double sums[kSide / kBlock][kSide / kBlock] = {};
            for (unsigned y = 0; y < kSide; ++y) {
                for (unsigned x = 0; x < kSide; ++x) {
                    sums[y / kBlock][x / kBlock] += film.mean(x, y).y - reference.mean(x, y).y;
                }
            }
            for (const auto& row : sums) {
                for (const double sum : row) squares += sum * sum;
            }
        }
        return std::sqrt(squares);
    };
    for (const unsigned samples : {1u, 3u}) {
        EXPECT_LT(blockError(&blue, samples), 0.8 * blockError(nullptr, samples)) << samples;
    }
}

/// Guards against scenes of odd numbers giving NaN: every sample of every pixel is a number.
TEST(Integrator, BadNumbersStayOutOfThePicture) {
    const float nan = std::nanf("");
    Scene scene = everything();
    for (Material& material : scene.materials) material.roughness = 0;
    Mesh mesh = scene.meshes[0];
    for (Float3& p : mesh.positions) p += Float3(0, 0.01f, 0);
    mesh.normals.assign(mesh.positions.size(), Float3(nan));
    mesh.normals[0] = {0, -1, 0};
    mesh.positions.emplace_back(nan, 0.0f, 0.0f);
    mesh.normals.emplace_back(0.0f, 0.0f, 0.0f);
    mesh.uvs.emplace_back(nan, nan);
    mesh.uvs[0] = {nan, 0};
    mesh.triangles.push_back({0, 1, 4});
    mesh.triangles.push_back({0, 1, 1});
    mesh.material = addMaterial(scene, [&] {
        Material material = scene.materials[3];
        material.baseColor = {nan, 2, -1};
        material.metallic = nan;
        material.emission = {1, 1, 1};
        return material;
    }());
    scene.meshes.push_back(mesh);
    SamplingOptions options;
    options.split = 2;
    options.distrib = true;
    const Film film = renderFilm(scene, kSide, 32, options);
    EXPECT_GT(channelMean(film, 0).mean, 0); // which also looks for invalid samples
}

} // namespace
} // namespace wellstrat::render
