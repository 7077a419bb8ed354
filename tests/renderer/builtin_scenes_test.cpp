// SPDX-License-Identifier: Apache-2.0
//
// The built-in scenes: each can be rendered, and the measured ones have the published numbers.

#include "renderer/builtin_scenes.h"
#include "renderer/framing.h"
#include "renderer/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

namespace wellstrat::render {
namespace {

class EachBuiltinScene : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> allNames() {
    std::vector<std::string> names;
    for (const auto& scene : builtinScenes()) names.emplace_back(scene.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Names, EachBuiltinScene, ::testing::ValuesIn(allNames()),
                         [](const auto& test) { return test.param; });

TEST(BuiltinScenes, HaveTheNamesOfTheInterface) {
    std::set<std::string> names;
    for (const auto& info : builtinScenes()) {
        names.insert(info.name);
        EXPECT_GT(std::string(info.description).size(), 10u);
        EXPECT_TRUE(isBuiltinScene(info.name));
    }
    EXPECT_EQ(names,
              (std::set<std::string>{"cornell", "veach", "lens", "manylights", "spherelight"}));
}

TEST(BuiltinScenes, AnUnknownNameListsTheKnownOnes) {
    EXPECT_FALSE(isBuiltinScene("cornel"));
    try {
        builtinScene("cornel");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "no built-in scene 'cornel'; there are: cornell, veach, lens, "
                     "manylights, spherelight");
    }
}

void expectValid(const Mesh& mesh, const Scene& scene) {
    ASSERT_LT(mesh.material, scene.materials.size());
    ASSERT_FALSE(mesh.triangles.empty());
    for (const Float3& p : mesh.positions)
        for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(p[c]));
    EXPECT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const uint32_t corner : mesh.triangles[i]) ASSERT_LT(corner, mesh.positions.size());
        EXPECT_GT(triangleAt(mesh, i, 0).areaNormal().Length(), 1e-4f);
    }
}

void expectValid(const Material& material) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(material.baseColor[c], 0.0f);
        EXPECT_LE(material.baseColor[c], 1.0f);
        EXPECT_TRUE(material.emission[c] >= 0.0f && std::isfinite(material.emission[c]));
    }
    EXPECT_TRUE(material.roughness >= 0.0f && material.roughness <= 1.0f);
}

TEST_P(EachBuiltinScene, CanBeRendered) {
    const Scene scene = builtinScene(GetParam());
    for (const Material& material : scene.materials) expectValid(material);
    for (const Mesh& mesh : scene.meshes) expectValid(mesh, scene);
    for (const Sphere& sphere : scene.spheres) {
        EXPECT_LT(sphere.material, scene.materials.size());
        EXPECT_GT(sphere.radius, 0.0f);
    }
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_GT(scene.aspect, 0.0f);
    const auto shines = [](const Material& m) { return largestChannel(m.emission) > 0.0f; };
    EXPECT_TRUE(scene.environment ||
                std::any_of(scene.materials.begin(), scene.materials.end(), shines));
}

TEST_P(EachBuiltinScene, HasACamera) {
    const Scene scene = builtinScene(GetParam());
    ASSERT_TRUE(scene.camera);
    const Camera& camera = *scene.camera;
    EXPECT_NEAR(camera.forward.Length(), 1.0f, 1e-6f);
    EXPECT_NEAR(camera.up.Length(), 1.0f, 1e-6f);
    EXPECT_NEAR(Dot(camera.forward, camera.up), 0.0f, 1e-6f);
    EXPECT_GT(camera.verticalFov, 0.1f);
    EXPECT_LT(camera.verticalFov, 2.0f);
    EXPECT_GT(camera.focusDistance, 0.0f);
    EXPECT_FALSE(scene.cameraIsAutomatic);
}

Bounds meshBounds(const Mesh& mesh) {
    Scene scene;
    scene.meshes.push_back(mesh);
    return sceneBounds(scene);
}

/// The x, y and z at which a scene's geometry begins and ends.
void expectBounds(const Scene& scene, Float3 low, Float3 high) {
    const Bounds bounds = sceneBounds(scene);
    for (int c = 0; c < 3; ++c) {
        EXPECT_FLOAT_EQ(bounds.low[c], low[c]);
        EXPECT_FLOAT_EQ(bounds.high[c], high[c]);
    }
}

float area(const Mesh& mesh) {
    float sum = 0;
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i)
        sum += triangleAt(mesh, i, 0).areaNormal().Length() / 2;
    return sum;
}

// https://www.graphics.cornell.edu/online/box/data.html
TEST(CornellBox, HasThePublishedDimensions) {
    const Scene scene = builtinScene("cornell");
    expectBounds(scene, {0, 0, 0}, {556.0f, 548.8f, 559.2f});
    ASSERT_EQ(scene.meshes.size(), 6u);
    const float shell = area(scene.meshes[0]); // floor, back and ceiling, without its hole
    EXPECT_NEAR(shell,
                (552.8f + 549.6f) / 2 * 559.2f + (549.6f + 556.0f) / 2 * 548.8f + 556.0f * 559.2f -
                    130.0f * 105.0f,
                1.0f);
    EXPECT_NEAR(area(scene.meshes[3]), 130.0f * 105.0f, 1e-2f);
    EXPECT_FLOAT_EQ(meshBounds(scene.meshes[4]).high.y, 165.0f);
    EXPECT_FLOAT_EQ(meshBounds(scene.meshes[5]).high.y, 330.0f);
}

TEST(CornellBox, HasThePublishedCamera) {
    const Camera camera = *builtinScene("cornell").camera;
    EXPECT_EQ(camera.position, Float3(278, 273, -800));
    EXPECT_EQ(camera.forward, Float3(0, 0, 1));
    EXPECT_EQ(camera.up, Float3(0, 1, 0));
    EXPECT_NEAR(std::tan(camera.verticalFov / 2), 0.025f / 2 / 0.035f, 1e-6f);
    EXPECT_EQ(camera.lensRadius, 0.0f);
}

// All surfaces face the air between the walls: the walls inward, the blocks outward, the light
// down.
TEST(CornellBox, SurfacesFaceTheAir) {
    const Scene scene = builtinScene("cornell");
    const Float3 middle(278, 274.4f, 279.6f);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const Mesh& mesh = scene.meshes[m];
        const bool isBlock = m >= 4;
        const Bounds bounds = meshBounds(mesh);
        const Float3 inside = isBlock ? bounds.center() : middle;
        for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const Triangle t = triangleAt(mesh, i, 0);
            const float side = Dot(t.areaNormal(), inside - t.a);
            EXPECT_TRUE(isBlock ? side < 0 : side > 0) << "mesh " << m << ", triangle " << i;
        }
    }
}

// Against the spectra by eye: white is 0.70 to 0.78 from 430 nm on, red is 0.6 in the red and 0.06
// elsewhere, green is 0.48 at its peak; the light grows with the wavelength from 0 to 18.4.
TEST(CornellBox, ColorsFollowTheSpectra) {
    const Scene scene = builtinScene("cornell");
    const Float3 white = scene.materials[0].baseColor, red = scene.materials[1].baseColor;
    const Float3 green = scene.materials[2].baseColor, light = scene.materials[3].emission;
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(white[c], 0.70f);
        EXPECT_LT(white[c], 0.78f);
    }
    EXPECT_GT(red.x, 0.4f);
    EXPECT_LT(std::max(red.y, red.z), 0.06f);
    EXPECT_GT(green.y, 0.3f);
    EXPECT_LT(std::max(green.x, green.z), 0.15f);
    EXPECT_GT(light.x, light.y);
    EXPECT_GT(light.y, light.z);
    EXPECT_LT(light.x, 18.4f);
    EXPECT_GT(light.z, 0.0f);
    for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(scene.materials[m].specularF0, 0.0f);
}

// The claim in scenes/spherelight.cpp, that every point of the picture has the closed form.
TEST(SphereLight, OnlyThePlaneIsInThePicture) {
    const Scene scene = builtinScene("spherelight");
    const Camera& camera = *scene.camera;
    const Sphere& sphere = scene.spheres.at(0);
    const Float3 right = Cross(camera.forward, camera.up);
    const float half = std::tan(camera.verticalFov / 2);
    for (int i = -20; i <= 20; ++i) {
        for (int j = -20; j <= 20; ++j) {
            const auto x = static_cast<float>(i) / 20, y = static_cast<float>(j) / 20;
            Float3 ray = camera.forward + right * (half * x) + camera.up * (half * y);
            ray.Normalize();
            const Float3 toSphere = sphere.center - camera.position;
            EXPECT_GT(Cross(toSphere, ray).Length(), sphere.radius);
            const Float3 hit = camera.position + ray * (-camera.position.y / ray.y);
            EXPECT_LT(std::max(std::abs(hit.x), std::abs(hit.z)), 100.0f);
            EXPECT_LT(ray.y, 0.0f);
        }
    }
    EXPECT_GE(sphere.center.y, sphere.radius);
}

TEST(Veach, LightsHaveTheSamePower) {
    const Scene scene = builtinScene("veach");
    ASSERT_EQ(scene.spheres.size(), 4u);
    for (const Sphere& sphere : scene.spheres) {
        const float radiance = largestChannel(scene.materials[sphere.material].emission);
        EXPECT_NEAR(radiance * sphere.radius * sphere.radius, 2.5f, 1e-4f);
    }
}

TEST(Lens, HasDepthOfFieldAndMotion) {
    const Scene scene = builtinScene("lens");
    EXPECT_GT(scene.camera->lensRadius, 0.0f);
    const auto moves = [](const Sphere& sphere) { return sphere.centerAtEnd.has_value(); };
    EXPECT_EQ(std::count_if(scene.spheres.begin(), scene.spheres.end(), moves), 2);
}

TEST(ManyLights, AreManyAndOfVeryDifferentPower) {
    const Scene scene = builtinScene("manylights");
    float least = 1e30f, most = 0;
    unsigned lights = 0;
    const auto see = [&](uint32_t material, float lightArea) {
        const float power = luminance(scene.materials[material].emission) * lightArea;
        if (power == 0.0f) return;
        ++lights;
        least = std::min(least, power);
        most = std::max(most, power);
    };
    for (const Mesh& mesh : scene.meshes) see(mesh.material, area(mesh));
    for (const Sphere& s : scene.spheres) see(s.material, 4 * 3.14159f * s.radius * s.radius);
    EXPECT_EQ(lights, 144u);
    EXPECT_GT(most, 100 * least);
}

} // namespace
} // namespace wellstrat::render
