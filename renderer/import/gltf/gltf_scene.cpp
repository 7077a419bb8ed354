// SPDX-License-Identifier: Apache-2.0

#include "gltf_scene.h"
#include "../scene_builder.h"
#include "cameras.h"
#include "document.h"
#include "lights.h"
#include "materials.h"
#include "nodes.h"
#include "primitives.h"
#include "skins.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace wellstrat::render {
namespace {

class GltfImport {
public:
    GltfImport(const std::string& path, uint64_t mostTriangles)
        : builder_(path, mostTriangles), document_(path, builder_.files, builder_.notes),
          nodes_(readNodes(document_, mostTriangles, builder_.notes)) {}

    Scene run() {
        const tinygltf::Model& model = document_.model();
        GltfTextures textures(document_, builder_.notes);
        for (const tinygltf::Material& material : model.materials)
            materials_.push_back(importMaterial(material, textures, builder_.notes));
        // That of primitives without one is the last.
        materials_.push_back(importMaterial({}, textures, builder_.notes));
        for (const GltfMaterial& material : materials_)
            builder_.scene.materials.push_back(material.material);

        addMeshes();
        builder_.scene.lights = importLights(document_, nodes_.lights, builder_.notes);
        builder_.scene.cameras = importCameras(document_, nodes_.cameras, builder_.notes);
        if (!model.animations.empty()) builder_.notes.add("Animations are left out.");
        return builder_.finish();
    }

private:
    /// Mesh by mesh, so that each is read once.
    void addMeshes() {
        std::map<int, std::vector<const GltfInstance*>> instances;
        for (const GltfInstance& instance : nodes_.meshes)
            instances[instance.number].push_back(&instance);
        for (const auto& [number, ofMesh] : instances) {
            const tinygltf::Mesh& mesh = at(document_.model().meshes, number, "mesh");
            for (const tinygltf::Primitive& primitive : mesh.primitives)
                addPrimitive(primitive, mesh.weights, ofMesh);
        }
    }

    void addPrimitive(const tinygltf::Primitive& source, const std::vector<double>& weights,
                      const std::vector<const GltfInstance*>& instances) {
        const GltfPrimitive primitive(document_, source, builder_.notes);
        if (primitive.vertexCount() == 0) return;
        const std::size_t material = materialOf(source);
        const std::vector<double>* known = nullptr;
        Mesh mesh;
        for (const GltfInstance* const instance : instances) {
            const auto& own = instance->node->weights.empty() ? weights : instance->node->weights;
            if (!known || *known != own) {
                mesh = primitive.mesh(own, materials_[material].uvSets, builder_.dropped);
                mesh.material = static_cast<uint32_t>(material);
                known = &own;
            }
            builder_.expect(mesh.triangles.size());
            add(mesh, primitive, *instance);
        }
    }

    void add(const Mesh& mesh, const GltfPrimitive& primitive, const GltfInstance& instance) {
        const int skin = instance.node->skin;
        if (skin >= 0) {
            Mesh posed = mesh;
            if (pose(posed, document_, primitive, skin, nodes_.toWorld)) {
                builder_.notes.add("Skeletons stand as the file has them.");
                return builder_.add(posed, {});
            }
        }
        builder_.add(mesh, instance.toWorld);
    }

    std::size_t materialOf(const tinygltf::Primitive& primitive) const {
        if (primitive.material < 0) return materials_.size() - 1;
        at(document_.model().materials, primitive.material, "material");
        return static_cast<std::size_t>(primitive.material);
    }

    SceneBuilder builder_;
    GltfDocument document_;
    GltfNodes nodes_;
    std::vector<GltfMaterial> materials_;
};

} // namespace

Scene importGltf(const std::string& path, uint64_t mostTriangles) {
    return GltfImport(path, mostTriangles).run();
}

} // namespace wellstrat::render
