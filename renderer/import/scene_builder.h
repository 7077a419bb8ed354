// SPDX-License-Identifier: Apache-2.0
//
// What all readers of scene files do alike: place meshes, count, and say what was left out.

#pragma once

#include "../scene.h"
#include "affine.h"
#include "files.h"
#include "notes.h"
#include "placing.h"

#include <cstdint>
#include <string>

namespace wellstrat::render {

class SceneBuilder {
public:
    /// For the scene file `path`. `mostTriangles` is of the whole scene, all instances counted.
    SceneBuilder(const std::string& path, uint64_t mostTriangles);

    Scene scene;
    FileFinder files;
    Notes notes;
    Dropped dropped;

    /// Says that meshes of so many triangles will be added. Throws std::runtime_error if these
    /// are too many.
    void expect(uint64_t triangles);

    /// Adds the mesh as `toWorld` places it, if anything of it can be rendered.
    void add(const Mesh& mesh, const Affine& toWorld);

    /// The scene, with its files, and notes on what was left out. Throws std::runtime_error if it
    /// is empty.
    Scene finish();

private:
    uint64_t mostTriangles_;
    uint64_t expected_ = 0;
};

} // namespace wellstrat::render
