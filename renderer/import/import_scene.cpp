// SPDX-License-Identifier: Apache-2.0

#include "import_scene.h"
#include "assimp_scene.h"
#include "gltf/gltf_scene.h"
#include "obj/obj_scene.h"
#include "ply/ply_scene.h"

#include <cctype>
#include <filesystem>
#include <fstream>

namespace wellstrat::render {
namespace {

std::string lowerCase(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string headOf(const std::string& path) {
    char bytes[4] = {};
    std::ifstream(path, std::ios::binary).read(bytes, sizeof bytes);
    return {bytes, sizeof bytes};
}

} // namespace

Scene importScene(const std::string& path, uint64_t mostTriangles) {
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    const std::string head = headOf(path);
    if (extension == ".gltf" || extension == ".glb" || head == "glTF")
        return importGltf(path, mostTriangles);
    if (extension == ".ply" || head == "ply\n" || head == "ply\r")
        return importPly(path, mostTriangles);
    if (extension == ".obj") return importObj(path, mostTriangles);
    return importByAssimp(path, mostTriangles);
}

} // namespace wellstrat::render
