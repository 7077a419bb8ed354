// SPDX-License-Identifier: Apache-2.0
//
// libFuzzer's target for scene files: any bytes may be refused, or give a scene that can be
// rendered, and whose picture has no NaN. scripts/fuzz runs it.
//
// The bytes are a .glb file if they begin with "glTF", a .gltf file if they begin with "{", a .ply
// file if they begin with "ply", an .obj file otherwise. What follows a line "#mtl" of an .obj file
// is its scene.mtl.

#include "renderer/framing.h"
#include "renderer/import/import_scene.h"
#include "renderer/render.h"
#include "renderer/scene_check.h"
#include "renderer/shapes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace wellstrat::render {
namespace {

namespace fs = std::filesystem;

void require(bool holds) {
    if (!holds) std::abort();
}

bool isFinite(Float3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool isInUnitRange(float x) { return x >= 0.0f && x <= 1.0f; }

void requireValid(const Material& material) {
    for (int c = 0; c < 3; ++c) {
        require(isInUnitRange(material.baseColor[c]));
        require(std::isfinite(material.emission[c]) && material.emission[c] >= 0.0f);
    }
    require(isInUnitRange(material.metallic) && isInUnitRange(material.roughness) &&
            isInUnitRange(material.specularF0));
}

void requireValid(const Mesh& mesh) {
    require(!mesh.triangles.empty());
    require(std::all_of(mesh.positions.begin(), mesh.positions.end(), isFinite));
    for (const Float3 n : mesh.normals) require(std::abs(n.Length() - 1) < 1e-3f);
    for (const auto* uvs : {&mesh.uvs, &mesh.secondUvs})
        for (const Float2 uv : *uvs) require(std::isfinite(uv.x) && std::isfinite(uv.y));
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i)
        require(triangleAt(mesh, i, 0).areaNormal().Length() > 0.0f);
}

void requireValid(const Scene& scene) {
    checkScene(scene);
    for (const Material& material : scene.materials) requireValid(material);
    for (const Mesh& mesh : scene.meshes) requireValid(mesh);
    for (const PunctualLight& light : scene.lights)
        require(isFinite(light.position) && isFinite(light.intensity) &&
                light.cosOuter <= light.cosInner);
    require(scene.aspect > 0.0f && std::isfinite(scene.aspect));
}

void render(const Scene& scene) {
    const Renderer renderer(scene, 4, 4, {});
    Film film(4, 4);
    const std::atomic<bool> stop{false};
    renderer.render({0, 4, 0, 1, nullptr}, film, stop, [](uint64_t) {});
    for (unsigned i = 0; i < 16; ++i) require(film.pixel(i % 4, i / 4).invalid == 0);
}

/// The folder of this process in which scene files are written.
const fs::path& folder() {
    static const fs::path path = [] {
        const char* const memory = "/dev/shm";
        const fs::path parent = fs::is_directory(memory) ? memory : fs::temp_directory_path();
        fs::path own = parent / ("wellstrat_fuzz_" + std::to_string(::getpid()));
        fs::create_directories(own);
        std::atexit([] { fs::remove_all(folder()); });
        return own;
    }();
    return path;
}

std::string write(const char* name, const std::string& bytes) {
    const fs::path path = folder() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path.string();
}

std::string writeScene(const std::string& bytes) {
    if (bytes.rfind("glTF", 0) == 0) return write("scene.glb", bytes);
    if (bytes.rfind('{', 0) == 0) return write("scene.gltf", bytes);
    if (bytes.rfind("ply", 0) == 0) return write("scene.ply", bytes);
    const std::size_t split = std::min(bytes.find("\n#mtl\n"), bytes.size());
    write("scene.mtl", bytes.substr(split));
    return write("scene.obj", bytes.substr(0, split));
}

} // namespace
} // namespace wellstrat::render

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace wellstrat::render;
    Scene scene;
    try {
        scene = importScene(writeScene({reinterpret_cast<const char*>(data), size}));
    } catch (const std::exception&) {
        return 0;
    }
    if (!scene.cameras.empty()) scene.camera = scene.cameras.front().camera;
    addWhatIsMissing(scene);
    requireValid(scene);
    render(scene);
    return 0;
}
