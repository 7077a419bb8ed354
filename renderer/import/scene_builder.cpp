// SPDX-License-Identifier: Apache-2.0

#include "scene_builder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {

SceneBuilder::SceneBuilder(const std::string& path, uint64_t mostTriangles)
    : files(std::filesystem::path(path).parent_path().string()), mostTriangles_(mostTriangles) {}

void SceneBuilder::expect(uint64_t triangles) {
    if (triangles > mostTriangles_ - expected_)
        throw std::runtime_error(
            fmt::format("has more than {} triangles, all instances counted", mostTriangles_));
    expected_ += triangles;
}

void SceneBuilder::add(const Mesh& mesh, const Affine& toWorld) {
    Mesh inWorld = placed(mesh, toWorld, dropped);
    if (!inWorld.triangles.empty()) scene.meshes.push_back(std::move(inWorld));
}

Scene SceneBuilder::finish() {
    const auto texts = dropped.texts();
    if (scene.meshes.empty())
        throw std::runtime_error(fmt::format("there are no triangles to render in it{}{}",
                                             texts.empty() ? "" : ", only ",
                                             fmt::join(texts, ", ")));
    for (const std::string& text : texts) notes.add(fmt::format("Left out: {}.", text));
    scene.files = files.take();
    scene.notes = notes.take();
    return std::move(scene);
}

} // namespace wellstrat::render
