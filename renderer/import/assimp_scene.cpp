// SPDX-License-Identifier: Apache-2.0
//
// Scenes by Assimp: all formats but glTF, OBJ and PLY.

#include "assimp_scene.h"
#include "conversions.h"
#include "lights_and_cameras.h"
#include "materials.h"
#include "meshes.h"
#include "scene_builder.h"
#include "scene_textures.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

/// That of the machine, which remembers what the importer opens.
class FileSystem : public Assimp::DefaultIOSystem {
public:
    explicit FileSystem(FileFinder& files) : files_(files) {}

    Assimp::IOStream* Open(const char* path, const char* mode) override {
        Assimp::IOStream* const stream = DefaultIOSystem::Open(path, mode);
        if (stream) files_.add(path);
        return stream;
    }

private:
    FileFinder& files_;
};

/// One mesh of the file where one node puts it.
struct Instance {
    const aiMesh* mesh;
    aiMatrix4x4 toWorld;
};

class SceneImport {
public:
    SceneImport(const aiScene& source, SceneBuilder& builder)
        : source_(source), builder_(builder), textures_(source, builder.files, builder.notes) {}

    Scene run() {
        for (unsigned i = 0; i < source_.mNumMaterials; ++i)
            materials_.push_back(importMaterial(*source_.mMaterials[i], textures_, builder_.notes));
        for (const ImportedMaterial& material : materials_)
            builder_.scene.materials.push_back(material.material);
        for (const Instance& instance : instances()) addMesh(instance);
        builder_.scene.lights = importLights(source_, builder_.notes);
        builder_.scene.cameras = importCameras(source_, builder_.notes);
        if (source_.mNumAnimations > 0) builder_.notes.add("Animations are left out.");
        return builder_.finish();
    }

private:
    /// Walks the nodes from the root. A loop, so that the depth of the tree takes no stack.
    std::vector<Instance> instances() {
        std::vector<Instance> found;
        std::vector<std::pair<const aiNode*, aiMatrix4x4>> open{{source_.mRootNode, {}}};
        while (!open.empty()) {
            const auto [node, parentToWorld] = open.back();
            open.pop_back();
            const aiMatrix4x4 toWorld = parentToWorld * node->mTransformation;
            for (unsigned i = 0; i < node->mNumMeshes; ++i) {
                const aiMesh* const mesh = source_.mMeshes[node->mMeshes[i]];
                found.push_back({mesh, toWorld});
                builder_.expect(mesh->mNumFaces);
            }
            for (unsigned i = node->mNumChildren; i-- > 0;)
                open.emplace_back(node->mChildren[i], toWorld);
        }
        return found;
    }

    void addMesh(const Instance& instance) {
        const unsigned material = instance.mesh->mMaterialIndex;
        Mesh mesh = importMesh(*instance.mesh, materials_.at(material).uvSet, builder_.dropped);
        mesh.material = material;
        builder_.add(mesh, toAffine(instance.toWorld));
        if (instance.mesh->HasBones())
            builder_.notes.add("Skeletons are left out: meshes stay as stored.");
        if (instance.mesh->HasVertexColors(0)) builder_.notes.add("Vertex colors are left out.");
    }

    const aiScene& source_;
    SceneBuilder& builder_;
    SceneTextures textures_;
    std::vector<ImportedMaterial> materials_;
};

} // namespace

Scene importByAssimp(const std::string& path, uint64_t mostTriangles) {
    SceneBuilder builder(path, mostTriangles);
    Assimp::Importer importer;
    importer.SetIOHandler(new FileSystem(builder.files)); // which the importer deletes
    const aiScene* const source =
        importer.ReadFile(path, aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                    aiProcess_TransformUVCoords);
    if (source && source->mRootNode) return SceneImport(*source, builder).run();
    if (!importer.IsExtensionSupported(std::filesystem::path(path).extension().string()))
        throw std::runtime_error(
            "there is no reader for this kind of file; glTF, OBJ, PLY and STL are read, and what "
            "Assimp reads");
    throw std::runtime_error(importer.GetErrorString());
}

} // namespace wellstrat::render
