// SPDX-License-Identifier: Apache-2.0

#include "scene_fingerprint.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <type_traits>
#include <vector>

namespace wellstrat::render {
namespace {

/// FNV-1a with 64 bits: Fowler, Noll, Vo, Eastlake 2019, "The FNV Non-Cryptographic Hash
/// Algorithm", draft-eastlake-fnv. Each list is preceded by its length, so that nothing can move
/// from one to the next unseen.
class Fingerprint {
public:
    uint64_t value() const { return hash_; }

    void add(const Scene& scene) {
        addAll(scene.materials);
        addAll(scene.meshes);
        addAll(scene.spheres);
        addAll(scene.lights);
        add(scene.environment);
        add(scene.camera);
    }

private:
    /// A number, an enumerator, or an array of numbers without padding.
    template <typename T>
    void add(const T& plain) {
        static_assert(std::is_trivially_copyable_v<T>, "bytes that mean something");
        const auto* const bytes = reinterpret_cast<const unsigned char*>(&plain);
        for (std::size_t i = 0; i < sizeof plain; ++i) hash_ = (hash_ ^ bytes[i]) * kPrime;
    }
    template <typename T>
    void addAll(const std::vector<T>& values) {
        add(values.size());
        for (const T& value : values) add(value);
    }
    template <typename T>
    void add(const std::optional<T>& value) {
        add(value.has_value());
        if (value) add(*value);
    }
    void add(const TexturePtr& texture) {
        add(texture == nullptr);
        if (texture) add(hashOf(texture.get()));
    }
    void add(const TextureMap& map) {
        add(map.texture);
        if (!map) return;
        add(map.sampling.u);
        add(map.sampling.v);
        add(map.sampling.nearest);
        add(map.transform);
        add(map.takesSecondUv);
    }
    void add(const Material& m) {
        add(m.baseColor);
        add(m.metallic);
        add(m.roughness);
        add(m.emission);
        add(m.doubleSided);
        add(m.specularF0);
        add(m.baseColorTexture);
        add(m.metallicRoughnessTexture);
        add(m.emissionTexture);
        add(m.specularColor);
        add(m.specularColorTexture);
        add(m.specularTexture);
        add(m.normalTexture);
        add(m.normalScale);
        add(m.opacityTexture);
        add(m.opacity);
        add(m.opacityCutoff);
        add(m.alpha);
        add(m.colorIsEmission);
        add(m.transmission);
        add(m.transmissionTexture);
        add(m.ior);
        add(m.isSolid);
        add(m.absorption);
    }
    void add(const Mesh& mesh) {
        addAll(mesh.positions);
        addAll(mesh.positionsAtEnd);
        addAll(mesh.normals);
        addAll(mesh.uvs);
        addAll(mesh.secondUvs);
        addAll(mesh.colors);
        addAll(mesh.triangles);
        add(mesh.material);
    }
    void add(const Sphere& sphere) {
        add(sphere.center);
        add(sphere.radius);
        add(sphere.material);
        add(sphere.centerAtEnd);
    }
    void add(const PunctualLight& light) {
        add(light.kind);
        add(light.position);
        add(light.direction);
        add(light.intensity);
        add(light.cosInner);
        add(light.cosOuter);
        add(light.range);
    }
    void add(const Environment& environment) {
        add(environment.radiance);
        add(environment.map);
        add(environment.rotation);
    }
    void add(const Camera& camera) {
        add(camera.position);
        add(camera.forward);
        add(camera.up);
        add(camera.verticalFov);
        add(camera.lensRadius);
        add(camera.focusDistance);
        add(camera.orthographicHeight);
    }

    /// Materials share textures: each is read once.
    uint64_t hashOf(const Texture* texture) {
        const auto known = textures_.find(texture);
        if (known != textures_.end()) return known->second;
        Fingerprint fingerprint;
        fingerprint.add(texture->width());
        fingerprint.add(texture->height());
        for (unsigned y = 0; y < texture->height(); ++y) {
            for (unsigned x = 0; x < texture->width(); ++x) fingerprint.add(texture->pixel(x, y));
        }
        return textures_[texture] = fingerprint.value();
    }

    static constexpr uint64_t kPrime = 0x100000001b3u;

    uint64_t hash_ = 0xcbf29ce484222325u;
    std::map<const Texture*, uint64_t> textures_;
};

} // namespace

std::string sceneFingerprint(const Scene& scene) {
    Fingerprint fingerprint;
    fingerprint.add(scene);
    return fmt::format("{:016x}", fingerprint.value());
}

} // namespace wellstrat::render
