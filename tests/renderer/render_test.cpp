// SPDX-License-Identifier: Apache-2.0
//
// Rendering is exact: the same bits however the work is split. And what passes promise.

#include "rendering.h"

#include "renderer/builtin_scenes.h"
#include "renderer/color.h"
#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstring>
#include <stdexcept>
#include <string>

namespace wellstrat::render {
namespace {

constexpr unsigned kWidth = 70, kHeight = 53; // no multiples of a tile
constexpr unsigned kSamples = 6;

const std::atomic<bool> kGoOn{false};
void ignore(uint64_t /*samples*/) {}

void expectSameBits(const Film& a, const Film& b) {
    for (unsigned y = 0; y < a.height(); ++y) {
        for (unsigned x = 0; x < a.width(); ++x) {
            const PixelSums& p = a.pixel(x, y);
            const PixelSums& q = b.pixel(x, y);
            ASSERT_EQ(p.count, q.count) << x << ", " << y;
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(p.color[c] == q.color[c]) << x << ", " << y;
            }
            ASSERT_TRUE(p.square == q.square) << x << ", " << y;
        }
    }
}

SamplingOptions allOptions(const Generator* generator) {
    SamplingOptions options;
    options.generator = generator;
    options.split = 2;
    options.distrib = true;
    return options;
}

struct ExactCase {
    const char* name;
    const char* scene;
    const Generator* generator;
};

const JointProgressive kJoint;
const LongProgressive kLong;
const BlueProgressive kBlue;

class Exactness : public ::testing::TestWithParam<ExactCase> {
protected:
    const Scene scene = builtinScene(GetParam().scene);
    const SamplingOptions options = allOptions(GetParam().generator);
    const Renderer renderer{scene, kWidth, kHeight, options};

    Film whole() const {
        Film film(kWidth, kHeight);
        renderer.render({0, kHeight, 0, kSamples}, film, kGoOn, ignore);
        return film;
    }
};

INSTANTIATE_TEST_SUITE_P(
    Scenes, Exactness,
    ::testing::Values(ExactCase{"cornell", "cornell", nullptr}, ExactCase{"lens", "lens", nullptr},
                      ExactCase{"veach", "veach", nullptr}, ExactCase{"joint", "lens", &kJoint},
                      ExactCase{"long", "lens", &kLong}, ExactCase{"blue", "lens", &kBlue}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(Exactness, AnyNumberOfThreads) {
    const Film film = whole();
    for (const int threads : {1, 2, 7}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        tbb::task_arena arena(threads);
        arena.execute([&] { expectSameBits(whole(), film); });
    }
}

/// Another Renderer builds its own search structure, in whatever order its threads run.
TEST_P(Exactness, AnyBuildOfTheGeometry) {
    const Renderer another(scene, kWidth, kHeight, options);
    Film film(kWidth, kHeight);
    another.render({0, kHeight, 0, kSamples}, film, kGoOn, ignore);
    expectSameBits(film, whole());
}

/// Rows from the bottom up, and other tiles.
TEST_P(Exactness, AnyOrderOfTiles) {
    Film film(kWidth, kHeight);
    for (unsigned end = kHeight; end > 0;) {
        const unsigned first = end > 7 ? end - 7 : 0;
        renderer.render({first, end, 0, kSamples}, film, kGoOn, ignore);
        end = first;
    }
    expectSameBits(film, whole());
}

TEST_P(Exactness, AnySplitOfTheSamples) {
    Film inPasses(kWidth, kHeight);
    renderer.render({0, kHeight, 0, 1}, inPasses, kGoOn, ignore);
    renderer.render({0, kHeight, 0, 4}, inPasses, kGoOn, ignore);
    renderer.render({0, kHeight, 0, kSamples}, inPasses, kGoOn, ignore);
    expectSameBits(inPasses, whole());

    Film first(kWidth, kHeight);
    Film second(kWidth, kHeight);
    renderer.render({0, kHeight, 0, 2}, first, kGoOn, ignore);
    renderer.render({0, kHeight, 2, kSamples}, second, kGoOn, ignore);
    second.add(first);
    expectSameBits(second, whole());
}

/// Pixels that are left out, and done later, get the samples that they would have had.
TEST_P(Exactness, AnyChoiceOfPixels) {
    std::vector<uint8_t> done(kWidth * kHeight);
    for (std::size_t i = 0; i < done.size(); ++i) done[i] = i % 3 == 0;
    Film film(kWidth, kHeight);
    renderer.render({0, kHeight, 0, 4, &done}, film, kGoOn, ignore);
    EXPECT_EQ(film.pixel(0, 0).count, 0u);
    EXPECT_EQ(film.pixel(1, 0).count, 4u);
    renderer.render({0, kHeight, 0, kSamples}, film, kGoOn, ignore);
    expectSameBits(film, whole());
}

/// A sequence moves the camera of one renderer: the same bits as of a renderer for each frame.
TEST(Renderer, TheCameraCanMove) {
    const Scene before = builtinScene("lens");
    Scene after = before;
    after.camera = turned(*before.camera, {0, 1, 0}, {0, 1, 0}, 10);
    Renderer renderer(before, 16, 16, {});
    const auto render = [](const Renderer& by) {
        Film film(16, 16);
        by.render({0, 16, 0, 2}, film, kGoOn, ignore);
        return film;
    };
    const Film first = render(renderer);
    renderer.setCamera(*after.camera);
    const Film second = render(renderer);
    expectSameBits(second, render(Renderer(after, 16, 16, {})));
    EXPECT_NE(first.mean(8, 8), second.mean(8, 8));
    Camera broken = *after.camera;
    broken.verticalFov = 4;
    EXPECT_THROW(renderer.setCamera(broken), std::invalid_argument);
    expectSameBits(render(renderer), second);
}

TEST(Renderer, CountsSamplesAndSegments) {
    Scene scene;
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 1}, {1, 0, 0})},
             addMaterial(scene, lambertian(Float3(1.0f))));
    scene.environment.emplace();
    scene.camera = pointCamera({0, 5, 0}, Float3(0.0f));
    const Renderer renderer(scene, 20, 10, {});
    Film film(20, 10);
    std::atomic<uint64_t> samples{0};
    renderer.render({0, 10, 0, 3}, film, kGoOn, [&](uint64_t count) { samples += count; });
    EXPECT_EQ(samples, 600u);
    EXPECT_EQ(renderer.segments(), 1200u); // to the plate, and away from it
}

TEST(Renderer, StopsBetweenTilesWithWholePixels) {
    const Scene scene = builtinScene("spherelight");
    const Renderer renderer(scene, 64, 64, {});
    Film film(64, 64);
    std::atomic<bool> stop{false};
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    renderer.render({0, 64, 0, 4}, film, stop, [&](uint64_t) { stop = true; });
    unsigned done = 0;
    for (unsigned y = 0; y < 64; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            const unsigned count = film.pixel(x, y).count;
            EXPECT_TRUE(count == 0 || count == 4);
            done += count / 4;
        }
    EXPECT_EQ(done, 256u);
    stop = false;
    renderer.render({0, 64, 0, 4}, film, stop, ignore);
    Film whole(64, 64);
    renderer.render({0, 64, 0, 4}, whole, stop, ignore);
    expectSameBits(film, whole);
}

template <class Change>
void expectRefused(const Change& change, const char* because) {
    Scene scene = builtinScene("cornell");
    change(scene);
    try {
        const Renderer renderer(scene, 8, 8, {});
        FAIL() << because;
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(because), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

TEST(Renderer, RefusesWhatItCannotRender) {
    expectRefused([](Scene& s) { s.camera.reset(); }, "has no camera");
    expectRefused([](Scene& s) { s.camera->position.x = std::nanf(""); }, "not finite");
    expectRefused([](Scene& s) { s.camera->forward *= 2; }, "length 1");
    expectRefused([](Scene& s) { s.camera->verticalFov = 4; }, "field of view");
    expectRefused([](Scene& s) { s.camera->focusDistance = 0; }, "focus");
    expectRefused([](Scene& s) { s.camera->focusDistance = 1e20f; }, "focus");
    expectRefused([](Scene& s) { s.camera->position.x = 1e19f; }, "position of the camera");
    expectRefused([](Scene& s) { s.camera->lensRadius = 1e20f; }, "lens");
    expectRefused([](Scene& s) { s.camera->lensRadius = -1; }, "lens");
    expectRefused([](Scene& s) { s.meshes[1].material = 99; }, "mesh 1 has a material");
    expectRefused([](Scene& s) { s.meshes[2].triangles[0][1] = 99999; }, "mesh 2 has a triangle");
    expectRefused([](Scene& s) { s.meshes[0].normals.resize(1); }, "different lengths");
    expectRefused(
        [](Scene& s) {
            s.spheres.push_back({{0, 0, 0}, 1, 99, {}});
        },
        "sphere 0 has a material");
    expectRefused([](Scene& s) { s.spheres.push_back({{0, 0, 0}, 0, 0, {}}); }, "radius");
    expectRefused([](Scene& s) { s.materials[0].emission.y = -1; }, "material 0");
    expectRefused([](Scene& s) { s.materials[0].emission.y = std::nanf(""); }, "material 0");
    expectRefused([](Scene& s) { s.lights.push_back({{}, {}, {}, Float3(-1.0f)}); }, "light 0");
    expectRefused([](Scene& s) { s.environment.emplace().radiance = Float3(-1.0f); },
                  "environment");
    const Scene scene = builtinScene("cornell");
    EXPECT_THROW(Renderer(scene, 0, 8, {}), std::invalid_argument);
    EXPECT_THROW(Renderer(scene, 8, 65537, {}), std::invalid_argument);
    SamplingOptions options;
    options.split = 0;
    EXPECT_THROW(Renderer(scene, 8, 8, options), std::invalid_argument);
}

TEST(Renderer, AnEmptySceneShowsItsEnvironment) {
    Scene scene;
    scene.environment.emplace();
    scene.camera = lookAt({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1);
    expectMean(renderFilm(scene, 16, 1), Float3(1.0f), 1e-9);
    scene.environment.reset();
    expectMean(renderFilm(scene, 16, 1), Float3(0.0f), 1e-9);
}

/// The background is left out of the colors, not out of what mirrors and walls see.
TEST(Render, TransparentBackgrounds) {
    Scene scene;
    scene.spheres.push_back({Float3(0.0f), 1, addMaterial(scene, lambertian(Float3(0.5f))), {}});
    scene.environment.emplace();
    scene.camera = lookAt({0, 0, 5}, Float3(0.0f), {0, 1, 0}, 0.8f);
    SamplingOptions options;
    const Film opaque = renderFilm(scene, 16, 16, options);
    EXPECT_FALSE(isTransparent(opaque));
    options.background = false;
    const Film film = renderFilm(scene, 16, 16, options);
    EXPECT_EQ(film.alpha(0, 0), 0.0f);
    EXPECT_TRUE(isBlack(film.mean(0, 0)));
    EXPECT_EQ(film.alpha(8, 8), 1.0f);
    double background = 0;
    for (unsigned y = 0; y < 16; ++y)
        for (unsigned x = 0; x < 16; ++x) {
            EXPECT_NEAR(film.mean(x, y).x + 1 - film.alpha(x, y), opaque.mean(x, y).x, 1e-5);
            background += 1 - film.alpha(x, y);
        }
    EXPECT_GT(background, 50);
    EXPECT_LT(background, 240);
}

} // namespace
} // namespace wellstrat::render
