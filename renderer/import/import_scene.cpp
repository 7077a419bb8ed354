// SPDX-License-Identifier: Apache-2.0

#include "import_scene.h"
#include "assimp_scene.h"
#include "gltf/gltf_scene.h"

#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace wellstrat::render {
namespace {

std::string lowerCase(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

bool isGltf(const std::string& path) {
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    if (extension == ".gltf" || extension == ".glb") return true;
    char magic[4] = {};
    std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
    return std::memcmp(magic, "glTF", sizeof magic) == 0;
}

} // namespace

Scene importScene(const std::string& path, uint64_t mostTriangles) {
    return isGltf(path) ? importGltf(path, mostTriangles) : importByAssimp(path, mostTriangles);
}

} // namespace wellstrat::render
