// SPDX-License-Identifier: Apache-2.0
//
// Surfaces that are not all there, colors of vertices, and normal maps.

#include "rendering.h"

#include "renderer/geometry.h"
#include "renderer/shapes.h"

#include <memory>

namespace wellstrat::render {
namespace {

TexturePtr picture(unsigned width, std::vector<Float3> pixels) {
    const auto height = static_cast<unsigned>(pixels.size()) / width;
    return std::make_shared<Texture>(width, height, std::move(pixels));
}

Material veil(float opacity, Float3 color = Float3(0.0f)) {
    Material material = lambertian(color);
    material.alpha = Material::Alpha::blend;
    material.opacity = opacity;
    return material;
}

/// Squares of 2 x 2 across the z axis, facing +z, at these distances from the origin, seen from
/// (0, 0, 10).
Scene squares(const std::vector<std::pair<float, Material>>& all) {
    Scene scene;
    for (const auto& [z, material] : all)
        addQuads(scene, {rectangle({0, 0, z}, {1, 0, 0}, {0, 1, 0})}, addMaterial(scene, material));
    scene.camera = pointCamera({0, 0, 10}, Float3(0.0f));
    return scene;
}

TEST(Opacity, MasksHaveHoles) {
    Material leaf = veil(1);
    leaf.alpha = Material::Alpha::mask;
    leaf.opacityTexture = picture(2, {Float3(0.4f), Float3(0.5f), Float3(0.6f), Float3(0.0f)});
    leaf.opacityTexture.sampling.nearest = true;
    const Scene scene = squares({{0, leaf}, {-1, lambertian(Float3(1.0f))}});
    const Geometry geometry(scene);
    const auto shapeAt = [&](float x, float y) {
        Hit hit{};
        EXPECT_TRUE(geometry.closestHit({{x, y, 5}, {0, 0, -1}}, hit));
        return hit.shape;
    };
    EXPECT_EQ(shapeAt(-0.5f, -0.5f), 1u); // u and v grow with x and y: 0.4, below the cutoff
    EXPECT_EQ(shapeAt(0.5f, -0.5f), 0u);  // at the cutoff
    EXPECT_EQ(shapeAt(-0.5f, 0.5f), 0u);
    EXPECT_EQ(shapeAt(0.5f, 0.5f), 1u);
    EXPECT_EQ(geometry.transmittance({{0.5f, 0.5f, 5}, {0, 0, -1}, 0, 5.5f}), 1.0f);
    EXPECT_EQ(geometry.transmittance({{-0.5f, 0.5f, 5}, {0, 0, -1}, 0, 5.5f}), 0.0f);
    EXPECT_FALSE(geometry.isBlended());
}

TEST(Opacity, LightPassesWhatIsLeft) {
    const Scene scene = squares({{0, veil(0.25f)}, {1, veil(0.5f)}, {2, veil(0.2f)}});
    const Geometry geometry(scene);
    EXPECT_FLOAT_EQ(geometry.transmittance({{0.1f, 0.2f, 5}, {0, 0, -1}}), 0.75f * 0.5f * 0.8f);
    EXPECT_FLOAT_EQ(geometry.transmittance({{0.1f, 0.2f, 5}, {0, 0, -1}, 0, 3.5f}), 0.8f);
    EXPECT_FLOAT_EQ(geometry.transmittance({{0.1f, 0.2f, 0.5f}, {0, 0, 1}}), 0.5f * 0.8f);
}

/// Each layer by its own chance: a ray that passes one is as likely to pass the next as any.
TEST(Opacity, RaysPassEachLayerByItself) {
    const Scene scene = squares({{0, veil(0.5f)}, {1, veil(0.5f)}, {-1, lambertian(Float3(1.0f))}});
    const Geometry geometry(scene);
    unsigned count[3] = {};
    for (uint32_t i = 0; i < 4096; ++i) {
        Ray ray{{0.1f, 0.2f, 5}, {0, 0, -1}};
        ray.chance = i;
        Hit hit{};
        ASSERT_TRUE(geometry.closestHit(ray, hit));
        ++count[hit.shape];
    }
    EXPECT_NEAR(count[1] / 4096.0, 0.5, 0.04);
    EXPECT_NEAR(count[0] / 4096.0, 0.25, 0.035);
    EXPECT_NEAR(count[2] / 4096.0, 0.25, 0.035);
}

TEST(Opacity, BlackVeilsDimTheirBackground) {
    Scene scene = squares({{0, veil(0.25f)}, {-1, veil(0.5f)}});
    scene.environment.emplace();
    expectMean(renderFilm(scene, 32, 64), Float3(0.75f * 0.5f), 1e-2);
}

/// White ones scatter what they do not let pass: nothing is lost in a furnace.
TEST(Opacity, WhiteVeilsLoseNothing) {
    Scene scene = squares({{0, veil(0.3f, Float3(1.0f))}, {-1, veil(0.6f, Float3(1.0f))}});
    scene.environment.emplace();
    expectMean(renderFilm(scene, 32, 64, optionsOfDepth(60)), Float3(1.0f), 1e-2);
}

/// By the light that is sampled, exactly.
TEST(Opacity, VeilsBeforeAPointLight) {
    Scene scene = squares({{0, lambertian(Float3(1.0f))}});
    PunctualLight light{};
    light.kind = PunctualLight::Kind::point;
    light.position = {5, 0, 5};
    light.intensity = Float3(50.0f);
    scene.lights = {light};
    const Float3 open = renderFilm(scene, 4, 16, optionsOfDepth(0)).mean(2, 2);
    addQuads(scene, {rectangle({2, 0, 2}, {0, 1, 0}, {0.5f, 0, -0.5f})},
             addMaterial(scene, veil(0.4f)));
    const Film dimmed = renderFilm(scene, 4, 16, optionsOfDepth(0));
    EXPECT_GT(open.x, 0.1f);
    EXPECT_NEAR(dimmed.mean(2, 2).x, 0.6f * open.x, 1e-5f * open.x);
}

/// A lamp of which a part is there, behind a veil: found by chance or sampled, it is as bright.
TEST(Opacity, AllStrategiesHaveOneMean) {
    Material lamp = emitter({8, 4, 2});
    lamp.alpha = Material::Alpha::blend;
    lamp.opacityTexture = picture(2, {Float3(0.1f), Float3(0.9f), Float3(0.5f), Float3(0.3f)});
    lamp.doubleSided = true;
    Scene scene = squares({{0, lambertian({0.8f, 0.6f, 0.9f})}});
    addQuads(scene, {rectangle({1.5f, 0, 1}, {0, 1, 0}, {0, 0, 1})}, addMaterial(scene, lamp));
    addQuads(scene, {rectangle({0.5f, 0, 1}, {0, 1, 0}, {0, 0, 1})},
             addMaterial(scene, veil(0.4f, Float3(0.5f))));
    scene.camera = lookAt({-1, 0.5f, 4}, {0.2f, 0, 0}, {0, 1, 0}, 0.6f);
    SamplingOptions options = optionsOfDepth(2);
    const Film both = renderFilm(scene, 24, 256, options);
    options.seed = 1;
    options.strategy = Strategy::lights;
    const Film lights = renderFilm(scene, 24, 256, options);
    options.seed = 2;
    options.strategy = Strategy::bxdf;
    const Film bxdf = renderFilm(scene, 24, 256, options);
    expectSameMean(both, lights);
    expectSameMean(both, bxdf);
}

TEST(VertexColors, MultiplyTheColorAndTheOpacity) {
    Scene scene = squares({{0, veil(0.5f, {0.5f, 0.5f, 1})}});
    scene.meshes[0].colors.assign(4, {{1, 0.5f, 0.25f}, 0.5f});
    scene.environment.emplace();
    scene.environment->radiance = {1, 1, 1};
    // A quarter is there, and scatters what its color says.
    const Float3 color(0.5f, 0.25f, 0.25f);
    expectMean(renderFilm(scene, 32, 64), Float3(0.75f) + color * 0.25f, 1e-2);
}

TEST(VertexColors, AreInterpolated) {
    Scene scene = squares({{0, lambertian(Float3(1.0f))}});
    scene.meshes[0].colors = {{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{1, 1, 0}, 1}, {{0, 1, 0}, 1}};
    const SurfaceAttributes at = triangleAttributes(scene.meshes[0], 0, 0.25f, 0.5f);
    EXPECT_EQ(at.color, Float3(0.75f, 0.5f, 0));
    EXPECT_EQ(at.opacity, 0.5f);
}

/// The shading normal in the middle of the square, for this color of the map.
Float3 mapped(Float3 color, const std::vector<Float2>& uvs, float scale = 1) {
    Material material = lambertian(Float3(1.0f));
    material.normalTexture = picture(1, {color});
    material.normalScale = scale;
    Scene scene = squares({{0, material}});
    scene.meshes[0].uvs = uvs;
    const Geometry geometry(scene);
    const Ray ray{{0.1f, 0.2f, 5}, {0, 0, -1}};
    Hit hit{};
    EXPECT_TRUE(geometry.closestHit(ray, hit));
    return geometry.surface(ray, hit).shadingNormal;
}

void expectDirection(Float3 a, Float3 b) {
    b.Normalize();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-5f);
}

// The corners are lower left, lower right, upper right, upper left.
TEST(NormalMaps, GoWithUAndAgainstV) {
    const std::vector<Float2> upright{{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    expectDirection(mapped({0.5f, 0.5f, 1}, upright), {0, 0, 1});
    expectDirection(mapped({0.75f, 0.5f, 1}, upright), {0.5f, 0, 1});
    expectDirection(mapped({0.5f, 0.75f, 1}, upright), {0, 0.5f, 1});
    expectDirection(mapped({0.75f, 0.75f, 1}, upright, 2), {1, 1, 1});
    // Turned by a quarter: u goes up, v to the right.
    const std::vector<Float2> turned{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    expectDirection(mapped({0.75f, 0.5f, 1}, turned), {0, 0.5f, 1});
    expectDirection(mapped({0.5f, 0.75f, 1}, turned), {-0.5f, 0, 1});
    // Mirrored: u goes to the left.
    const std::vector<Float2> mirrored{{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    expectDirection(mapped({0.75f, 0.5f, 1}, mirrored), {-0.5f, 0, 1});
    expectDirection(mapped({0.5f, 0.75f, 1}, mirrored), {0, 0.5f, 1});
}

TEST(NormalMaps, WithoutDirectionLeaveTheNormal) {
    expectDirection(mapped({0.75f, 0.5f, 1}, std::vector<Float2>(4, {0.5f, 0.5f})), {0, 0, 1});
    expectDirection(mapped({0.75f, 0.5f, 1}, {}), {0, 0, 1});
    expectDirection(mapped({0.5f, 0.5f, 0.5f}, {{0, 1}, {1, 1}, {1, 0}, {0, 0}}), {0, 0, 1});
}

} // namespace
} // namespace wellstrat::render
