// SPDX-License-Identifier: Apache-2.0

#include "obj_scene.h"
#include "../file_textures.h"
#include "../files.h"
#include "../scene_builder.h"
#include "libraries.h"
#include "materials.h"
#include "meshes.h"
#include "obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wellstrat::render {
namespace {

/// "'a', 'b'", and how many there are after the first ten.
std::string listOf(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 10;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
        list += fmt::format("{}'{}'", i == 0 ? "" : ", ", names[i]);
    return names.size() > kMost ? fmt::format("{} and {} more", list, names.size() - kMost) : list;
}

/// The materials that faces name. Those that no library has are as if it said nothing of them, and
/// white where vertices have colors.
std::vector<Material> materialsOf(const ObjFile& file, SceneBuilder& builder) {
    const auto known = readLibraries(file.libraries, builder.files, builder.notes);
    FileTextures textures(builder.files, builder.notes);
    MtlMaterial unknown;
    if (!file.colors.empty()) unknown.diffuse = Float3(1.0f);
    std::vector<Material> materials;
    std::vector<std::string> missing;
    for (const std::string& name : file.materials) {
        const auto source = std::find_if(known.begin(), known.end(),
                                         [&](const MtlMaterial& one) { return one.name == name; });
        const bool isKnown = source != known.end();
        if (!isKnown && !name.empty()) missing.push_back(name);
        materials.push_back(importMaterial(isKnown ? *source : unknown, textures, builder.notes));
    }
    if (!missing.empty())
        builder.notes.add(
            fmt::format("Materials that no library has are light gray: {}.", listOf(missing)));
    return materials;
}

uint64_t triangleCount(const ObjFile& file) { return file.corners.size() - 2 * file.faces.size(); }

} // namespace

Scene importObj(const std::string& path, uint64_t mostTriangles) {
    SceneBuilder builder(path, mostTriangles);
    const ObjFile file = parseObj(contentOf(path));
    builder.expect(triangleCount(file));
    builder.scene.materials = materialsOf(file, builder);
    for (const Mesh& mesh : meshesOf(file)) builder.add(mesh, {});
    builder.dropped.otherFaces += file.otherElements;
    if (file.hasFreeForms) builder.notes.add("Curves and curved surfaces are left out.");
    return builder.finish();
}

} // namespace wellstrat::render
