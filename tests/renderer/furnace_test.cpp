// SPDX-License-Identifier: Apache-2.0
//
// Furnace tests: where light comes evenly from everywhere, what a surface sends back is its albedo.
// Guards against wrong densities, lost or doubled light, and samples that are used twice.

#include "rendering.h"

#include "bxdf_reference.h"

#include <memory>

namespace wellstrat::render {
namespace {

/// A flat square of `material` at y = 0 under a constant light of radiance 1, seen at this angle
/// to the normal.
Scene plate(const Material& material, float angle) {
    Scene scene;
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 1}, {1, 0, 0})}, addMaterial(scene, material));
    scene.environment.emplace();
    scene.camera = pointCamera(Float3(std::sin(angle), std::cos(angle), 0) * 10, Float3(0.0f));
    return scene;
}

TexturePtr flatTexture(Float3 color) {
    return std::make_shared<Texture>(1, 1, std::vector<Float3>{color});
}

/// The same constant light as a map, so that it is sampled.
Environment whiteMap() {
    Environment environment;
    environment.map = std::make_shared<Texture>(8, 4, std::vector<Float3>(32, Float3(1.0f)));
    return environment;
}

TEST(Furnace, LambertianSphereIsExact) {
    Scene scene;
    scene.spheres.push_back({Float3(0.0f), 1, addMaterial(scene, lambertian(Float3(1.0f))), {}});
    scene.environment.emplace();
    scene.camera = lookAt({0, 0, 4}, Float3(0.0f), {0, 1, 0}, 0.8f);
    const Film film = renderFilm(scene, 32, 16);
    for (unsigned y = 0; y < 32; ++y)
        for (unsigned x = 0; x < 32; ++x)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.mean(x, y)[c], 1, 2e-6) << x << ", " << y;
}

TEST(Furnace, LambertianPlateIsExactAtAllAngles) {
    const Float3 color(0.9f, 0.5f, 0.1f);
    for (const float angle : {0.0f, 0.5f, 1.0f, 1.4f}) {
        const Film film = renderFilm(plate(lambertian(color), angle), 4, 16);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.mean(2, 2)[c], color[c], 1e-6) << angle;
    }
}

struct NamedMaterial {
    const char* name;
    Material material;
    Material plain; ///< the same without textures
};

Material metallicRoughness(Float3 color, float metallic, float roughness) {
    Material material;
    material.baseColor = color;
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

NamedMaterial untextured(const char* name, const Material& material) {
    return {name, material, material};
}

std::vector<NamedMaterial> materials() {
    const Float3 gold(1.0f, 0.77f, 0.34f);
    Material textured = metallicRoughness(Float3(0.8f), 0.5f, 1);
    textured.baseColorTexture = flatTexture({0.5f, 1, 0.25f});
    textured.metallicRoughnessTexture = flatTexture({0, 0.6f, 0.5f});
    Material water = metallicRoughness(gold, 0, 0.3f);
    water.specularF0 = 0.02f;
    return {untextured("Lambertian", lambertian(gold)),
            untextured("SmoothDielectric", metallicRoughness(gold, 0, 0.05f)),
            untextured("GlossyDielectric", metallicRoughness(gold, 0, 0.4f)),
            untextured("RoughDielectric", metallicRoughness(gold, 0, 1)),
            untextured("Water", water),
            untextured("Mirror", metallicRoughness(gold, 1, 0)),
            untextured("SmoothMetal", metallicRoughness(gold, 1, 0.2f)),
            untextured("GlossyMetal", metallicRoughness(gold, 1, 0.5f)),
            untextured("RoughMetal", metallicRoughness(gold, 1, 1)),
            untextured("HalfMetal", metallicRoughness(gold, 0.5f, 0.5f)),
            {"Textured", textured, metallicRoughness({0.4f, 0.8f, 0.2f}, 0.25f, 0.6f)}};
}

class EachMaterial : public ::testing::TestWithParam<NamedMaterial> {};

INSTANTIATE_TEST_SUITE_P(Furnace, EachMaterial, ::testing::ValuesIn(materials()),
                         [](const auto& test) { return test.param.name; });

/// Against the albedo by quadrature, which for rough GGX is below 1 by what would scatter twice.
TEST_P(EachMaterial, ReflectsItsAlbedo) {
    for (const float angle : {0.1f, 0.8f, 1.3f}) {
        SCOPED_TRACE(angle);
        const Film film = renderFilm(plate(GetParam().material, angle), 32, 64, optionsOfDepth(0));
        expectMean(film, reference::albedo(GetParam().plain, std::cos(angle)), 3e-3);
    }
}

/// The same with light samples as well, and with light samples alone.
TEST_P(EachMaterial, ReflectsItsAlbedoOfAMap) {
    if (GetParam().plain.roughness < 0.3f) return; // light samples alone would hardly converge
    for (const Strategy strategy : {Strategy::both, Strategy::lights}) {
        Scene scene = plate(GetParam().material, 0.8f);
        scene.environment.emplace(whiteMap());
        SamplingOptions options = optionsOfDepth(0);
        options.strategy = strategy;
        expectMean(renderFilm(scene, 32, 256, options),
                   reference::albedo(GetParam().plain, std::cos(0.8f)), 1e-2);
    }
}

/// A closed sphere or box that emits 1 and reflects half, seen from within: the emission, and what
/// of it is left after each bounce.
void expectSeries(Scene scene, const std::vector<Strategy>& strategies, double tolerance) {
    Material wall = lambertian(Float3(0.5f));
    wall.emission = Float3(1.0f);
    wall.doubleSided = true;
    scene.materials = {wall};
    scene.camera = lookAt({0.1f, 0.2f, 0.3f}, {1, 0, 0}, {0, 1, 0}, 1.5f);
    for (const unsigned depth : {0u, 1u, 4u, 60u}) {
        const auto sum = static_cast<float>(2 - std::pow(0.5, depth + 1));
        for (const Strategy strategy : strategies) {
            SCOPED_TRACE(depth);
            SamplingOptions options = optionsOfDepth(depth);
            options.strategy = strategy;
            expectMean(renderFilm(scene, 32, 64, options), Float3(sum), tolerance);
        }
    }
}

TEST(Furnace, SphereFromWithin) {
    Scene scene;
    scene.spheres.push_back({Float3(0.0f), 2, 0, {}});
    expectSeries(scene, {Strategy::both, Strategy::lights, Strategy::bxdf}, 1e-2);
}

TEST(Furnace, BoxFromWithin) {
    Scene scene;
    addQuads(scene, box(Float3(0.0f), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
    // Not by light samples alone: their variance is infinite in the corners.
    expectSeries(scene, {Strategy::both, Strategy::bxdf}, 1e-2);
}

} // namespace
} // namespace wellstrat::render
