// SPDX-License-Identifier: Apache-2.0
//
// Fingerprints: the same for the same scene, another one for every change.

#include "renderer/scene_fingerprint.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

TexturePtr textureOf(float red) {
    return std::make_shared<Texture>(2, 1, std::vector<Float3>{Float3(0.5f), {red, 0.5f, 0.5f}});
}

/// A scene in which everything is there.
Scene fullScene() {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[0].baseColorTexture = textureOf(0.5f);
    Mesh mesh;
    mesh.positions = mesh.positionsAtEnd = mesh.normals = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    scene.meshes = {mesh};
    scene.spheres = {{{1, 2, 3}, 4, 1, Float3(1, 2, 4)}};
    scene.lights = {{PunctualLight::Kind::spot, {1, 2, 3}, {0, 0, 1}, {1, 1, 1}, 0.9f, 0.5f}};
    scene.environment = Environment{{1, 1, 1}, textureOf(0.25f), 0};
    scene.camera = Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1, 0.1f, 2};
    return scene;
}

/// Guards against parts of a scene that are forgotten, and mistaken for each other.
TEST(SceneFingerprint, ChangesWithEverything) {
    const std::vector<std::function<void(Scene&)>> changes{
        [](Scene&) {},
        [](Scene& s) { s.materials[0].baseColor.y = 0.5f; },
        [](Scene& s) { s.materials[0].metallic = 1; },
        [](Scene& s) { s.materials[0].roughness = 0.5f; },
        [](Scene& s) { s.materials[0].emission.z = 1; },
        [](Scene& s) { s.materials[0].doubleSided = true; },
        [](Scene& s) { s.materials[0].specularF0 = 0; },
        [](Scene& s) { s.materials[0].baseColorTexture = textureOf(0.6f); },
        [](Scene& s) { s.materials[0].baseColorTexture = nullptr; },
        [](Scene& s) { s.materials[0].baseColorTexture.sampling.v = Wrap::clamp; },
        [](Scene& s) { s.materials[0].baseColorTexture.sampling.nearest = true; },
        [](Scene& s) { s.materials[0].baseColorTexture.transform.offset.y = 1; },
        [](Scene& s) { s.materials[0].baseColorTexture.takesSecondUv = true; },
        [](Scene& s) { s.materials[0].specularColor.z = 2; },
        [](Scene& s) { s.materials[0].specularColorTexture = textureOf(0.5f); },
        [](Scene& s) { s.materials[0].specularTexture = textureOf(0.5f); },
        [](Scene& s) { s.materials[0].normalTexture = textureOf(0.5f); },
        [](Scene& s) { s.materials[0].normalScale = 2; },
        [](Scene& s) { s.materials[0].opacityTexture = textureOf(0.5f); },
        [](Scene& s) { s.materials[0].opacity = 0.5f; },
        [](Scene& s) { s.materials[0].opacityCutoff = 0.25f; },
        [](Scene& s) { s.materials[0].alpha = Material::Alpha::mask; },
        [](Scene& s) { s.materials[0].colorIsEmission = true; },
        [](Scene& s) { s.materials[0].transmission = 0.5f; },
        [](Scene& s) { s.materials[0].transmissionTexture = textureOf(0.5f); },
        [](Scene& s) { s.materials[0].ior = 1.3f; },
        [](Scene& s) { s.materials[0].isSolid = true; },
        [](Scene& s) { s.materials[0].absorption.y = 1; },
        [](Scene& s) { s.materials[0].metallicRoughnessTexture = textureOf(0.5f); },
        [](Scene& s) { s.materials[0].emissionTexture = textureOf(0.5f); },
        [](Scene& s) { std::swap(s.materials[0], s.materials[1]); },
        [](Scene& s) { s.materials.pop_back(); },
        [](Scene& s) { s.meshes[0].positions[1].x = 2; },
        [](Scene& s) { s.meshes[0].positionsAtEnd[1].x = 2; },
        [](Scene& s) { s.meshes[0].positionsAtEnd.clear(); },
        [](Scene& s) { s.meshes[0].normals.clear(); },
        [](Scene& s) { s.meshes[0].uvs[2].x = 1; },
        [](Scene& s) { s.meshes[0].secondUvs = s.meshes[0].uvs; },
        [](Scene& s) {
            s.meshes[0].colors.assign(3, {Float3(1.0f), 1});
        },
        [](Scene& s) {
            s.meshes[0].triangles[0] = {0, 2, 1};
        },
        [](Scene& s) { s.meshes[0].material = 1; },
        [](Scene& s) { s.meshes.push_back(s.meshes[0]); },
        [](Scene& s) { s.spheres[0].radius = 5; },
        [](Scene& s) { s.spheres[0].centerAtEnd.reset(); },
        [](Scene& s) { s.spheres[0].centerAtEnd->z = 5; },
        [](Scene& s) { s.lights[0].kind = PunctualLight::Kind::point; },
        [](Scene& s) { s.lights[0].intensity.x = 2; },
        [](Scene& s) { s.lights[0].cosOuter = 0; },
        [](Scene& s) { s.environment->radiance.x = 2; },
        [](Scene& s) { s.environment->map = textureOf(0.5f); },
        [](Scene& s) { s.environment->rotation = 1; },
        [](Scene& s) { s.environment.reset(); },
        [](Scene& s) { s.camera->position.x = 1; },
        [](Scene& s) { s.camera->verticalFov = 2; },
        [](Scene& s) { s.camera->orthographicHeight = 2; },
        [](Scene& s) { s.lights[0].range = 2; },
        [](Scene& s) { s.camera->lensRadius = 0; },
        [](Scene& s) { s.camera->focusDistance = 1; },
    };
    std::set<std::string> seen;
    for (const auto& change : changes) {
        Scene scene = fullScene();
        change(scene);
        const std::string fingerprint = sceneFingerprint(scene);
        EXPECT_EQ(fingerprint.size(), 16u);
        seen.insert(fingerprint);
    }
    EXPECT_EQ(seen.size(), changes.size());
}

TEST(SceneFingerprint, DependsOnContentsOnly) {
    Scene scene = fullScene();
    scene.notes = {"a note"};
    EXPECT_EQ(sceneFingerprint(scene), sceneFingerprint(fullScene()));
}

} // namespace
} // namespace wellstrat::render
