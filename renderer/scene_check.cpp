// SPDX-License-Identifier: Apache-2.0
#include "scene_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace wellstrat::render {

namespace {

void require(bool condition, const std::string& otherwise) {
    if (!condition) throw std::invalid_argument(otherwise);
}

bool isFinite(Float3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Far beyond any scene, and far below 1e18, where Embree refuses rays.
constexpr float kFarthest = 1e16f;

bool isWithinReach(Float3 v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) <= kFarthest;
}

bool isLight(Float3 color) {
    return isFinite(color) && color.x >= 0.0f && color.y >= 0.0f && color.z >= 0.0f;
}

void checkLight(const Scene& scene) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        require(isLight(scene.materials[i].emission),
                "the emission of material " + std::to_string(i) + " is not finite or negative");
        require(isLight(scene.materials[i].absorption),
                "the absorption of material " + std::to_string(i) + " is not finite or negative");
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const PunctualLight& light = scene.lights[i];
        require(isLight(light.intensity) && isFinite(light.position) && isFinite(light.direction) &&
                    light.range > 0.0f,
                "light " + std::to_string(i) + " has numbers that are not finite, or negative");
    }
    require(!scene.environment || isLight(scene.environment->radiance),
            "the radiance of the environment is not finite or negative");
    require(!scene.environment || std::isfinite(scene.environment->rotation),
            "the rotation of the environment is not finite");
}

template <class T>
bool fits(const std::vector<T>& optional, const Mesh& mesh) {
    return optional.empty() || optional.size() == mesh.positions.size();
}

void checkMesh(const Mesh& mesh, std::size_t materials, const std::string& name) {
    require(mesh.material < materials, name + " has a material that does not exist");
    require(fits(mesh.positionsAtEnd, mesh) && fits(mesh.normals, mesh) && fits(mesh.uvs, mesh) &&
                fits(mesh.secondUvs, mesh) && fits(mesh.colors, mesh),
            name + " has arrays of different lengths");
    for (const auto& triangle : mesh.triangles) {
        require(std::max({triangle[0], triangle[1], triangle[2]}) < mesh.positions.size(),
                name + " has a triangle with a corner that does not exist");
    }
}

} // namespace

void checkCamera(const Camera& camera) {
    require(isFinite(camera.position) && isWithinReach(camera.position),
            "the position of the camera is not finite, or beyond 1e16");
    require(std::fabs(camera.forward.LengthSq() - 1.0f) < 1e-3f &&
                std::fabs(camera.up.LengthSq() - 1.0f) < 1e-3f &&
                std::fabs(Dot(camera.forward, camera.up)) < 1e-3f,
            "the camera's directions `forward` and `up` are not of length 1 and across each other");
    require(camera.verticalFov > 0.0f && camera.verticalFov < 3.14159f,
            "the camera's field of view is not between 0 and 180 degrees");
    require(camera.orthographicHeight >= 0.0f && camera.orthographicHeight <= kFarthest,
            "the height of the camera's picture is not a number from 0 to 1e16");
    require(camera.lensRadius >= 0.0f && camera.lensRadius <= kFarthest,
            "the radius of the camera's lens is not a number from 0 to 1e16");
    require(camera.focusDistance > 0.0f && camera.focusDistance <= kFarthest,
            "the camera's focus distance is not a number above 0 and at most 1e16");
}

void checkScene(const Scene& scene) {
    require(scene.camera.has_value(), "the scene has no camera");
    checkCamera(*scene.camera);
    checkLight(scene);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        checkMesh(scene.meshes[i], scene.materials.size(), "mesh " + std::to_string(i));
    }
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        const std::string name = "sphere " + std::to_string(i);
        require(sphere.material < scene.materials.size(),
                name + " has a material that does not exist");
        require(isFinite(sphere.center) && isFinite(sphere.centerAtEnd.value_or(sphere.center)) &&
                    std::isfinite(sphere.radius) && sphere.radius > 0.0f,
                name +
                    " has a center or radius that is not finite, or a radius that is not above 0");
    }
}

} // namespace wellstrat::render
