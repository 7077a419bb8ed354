// SPDX-License-Identifier: Apache-2.0
//
// Reads a scene file by Assimp, in this process.

#include "import_scene.h"
#include "gltf_file.h"
#include "lights_and_cameras.h"
#include "materials.h"
#include "meshes.h"
#include "notes.h"
#include "scene_textures.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

namespace fs = std::filesystem;

/// The file system, but for one file whose content is given.
class PatchedFiles : public Assimp::DefaultIOSystem {
public:
    PatchedFiles(std::string path, std::string content)
        : path_(std::move(path)), content_(std::move(content)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (file != path_) return Assimp::DefaultIOSystem::Open(file, mode);
        return new Assimp::MemoryIOStream(reinterpret_cast<const uint8_t*>(content_.data()),
                                          content_.size());
    }

private:
    std::string path_, content_;
};

std::string lowerCase(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

void prepareGltf(Assimp::Importer& importer, const std::string& path) {
    const std::string extension = lowerCase(fs::path(path).extension().string());
    if (extension != ".gltf" && extension != ".glb") return;
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (auto prepared = preparedGltf(bytes))
        importer.SetIOHandler(new PatchedFiles(path, std::move(*prepared)));
}

/// One mesh of the file where one node puts it.
struct Instance {
    const aiMesh* mesh;
    aiMatrix4x4 toWorld;
};

class SceneImport {
public:
    SceneImport(const aiScene& source, std::string folder, uint64_t mostTriangles)
        : source_(source), mostTriangles_(mostTriangles),
          textures_(source, std::move(folder), notes_) {}

    Scene run() {
        for (unsigned i = 0; i < source_.mNumMaterials; ++i)
            materials_.push_back(importMaterial(*source_.mMaterials[i], textures_, notes_));
        for (const ImportedMaterial& material : materials_)
            scene_.materials.push_back(material.material);
        for (const Instance& instance : instances()) addMesh(instance);
        scene_.lights = importLights(source_, notes_);
        if (const auto camera = importCamera(source_, notes_)) {
            scene_.camera = camera->camera;
            scene_.aspect = camera->aspect;
        }
        noteDropped();
        if (scene_.meshes.empty()) throw std::runtime_error(emptyReason());
        if (source_.mNumAnimations > 0) notes_.add("Animations are left out.");
        scene_.notes = notes_.take();
        return std::move(scene_);
    }

private:
    /// Walks the nodes from the root. A loop, so that the depth of the tree takes no stack.
    std::vector<Instance> instances() const {
        std::vector<Instance> found;
        std::vector<std::pair<const aiNode*, aiMatrix4x4>> open{{source_.mRootNode, {}}};
        uint64_t triangles = 0;
        while (!open.empty()) {
            const auto [node, parentToWorld] = open.back();
            open.pop_back();
            const aiMatrix4x4 toWorld = parentToWorld * node->mTransformation;
            for (unsigned i = 0; i < node->mNumMeshes; ++i) {
                const aiMesh* const mesh = source_.mMeshes[node->mMeshes[i]];
                found.push_back({mesh, toWorld});
                triangles += mesh->mNumFaces;
            }
            if (triangles > mostTriangles_)
                throw std::runtime_error(fmt::format(
                    "has more than {} triangles, all instances counted", mostTriangles_));
            for (unsigned i = node->mNumChildren; i-- > 0;)
                open.emplace_back(node->mChildren[i], toWorld);
        }
        return found;
    }

    void addMesh(const Instance& instance) {
        const unsigned material = instance.mesh->mMaterialIndex;
        Mesh mesh =
            importMesh(*instance.mesh, instance.toWorld, materials_.at(material).uvSet, dropped_);
        if (mesh.triangles.empty()) return;
        mesh.material = material;
        scene_.meshes.push_back(std::move(mesh));
        if (instance.mesh->HasBones()) notes_.add("Skeletons are left out: meshes stay as stored.");
        if (instance.mesh->HasVertexColors(0)) notes_.add("Vertex colors are left out.");
    }

    /// "COUNT WHAT" of all that was dropped.
    std::vector<std::string> droppedTexts() const {
        std::vector<std::string> texts;
        const auto add = [&](uint64_t count, const char* what) {
            if (count > 0) texts.push_back(fmt::format("{} {}", count, what));
        };
        add(dropped_.notFinite, "triangles with a corner that is no number");
        add(dropped_.tooFar, "triangles with a corner beyond 1e9");
        add(dropped_.degenerate, "triangles without area");
        add(dropped_.otherFaces, "lines and points");
        return texts;
    }

    void noteDropped() {
        for (const std::string& text : droppedTexts()) {
            notes_.add(fmt::format("Left out: {}.", text));
        }
    }

    std::string emptyReason() const {
        const auto texts = droppedTexts();
        return fmt::format("there are no triangles to render in it{}{}",
                           texts.empty() ? "" : ", only ", fmt::join(texts, ", "));
    }

    const aiScene& source_;
    const uint64_t mostTriangles_;
    Notes notes_;
    SceneTextures textures_;
    std::vector<ImportedMaterial> materials_;
    Dropped dropped_;
    Scene scene_;
};

} // namespace

Scene importScene(const std::string& path, uint64_t mostTriangles) {
    Assimp::Importer importer;
    prepareGltf(importer, path);
    const aiScene* const source =
        importer.ReadFile(path, aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                    aiProcess_TransformUVCoords);
    if (!source || !source->mRootNode) throw std::runtime_error(importer.GetErrorString());
    return SceneImport(*source, fs::path(path).parent_path().string(), mostTriangles).run();
}

} // namespace wellstrat::render
