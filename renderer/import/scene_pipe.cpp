// SPDX-License-Identifier: Apache-2.0
//
// Scenes through pipes, from one process to a copy of it.
//
// Both directions walk the same `transfer` functions, with a Writer or a Reader, so that they
// cannot disagree. The bytes are those of memory: both ends are the same program.

#include "scene_pipe.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <stdexcept>
#include <type_traits>

#include <unistd.h>

namespace wellstrat::render {
namespace {

class Writer {
public:
    explicit Writer(int pipe) : pipe_(pipe) {}

    void bytes(const void* data, std::size_t size) {
        const auto* next = static_cast<const char*>(data);
        while (size > 0) {
            const ssize_t written = ::write(pipe_, next, size);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) throw std::runtime_error(std::strerror(errno));
            next += written;
            size -= static_cast<std::size_t>(written);
        }
    }

    template <typename T>
    void count(const T& container) {
        const uint64_t size = container.size();
        bytes(&size, sizeof size);
    }

    /// Materials share textures: each goes once, and then by its number.
    void texture(const TexturePtr& texture) {
        const auto [known, isNew] = numbers_.try_emplace(texture.get(), numbers_.size());
        bytes(&known->second, sizeof known->second);
        if (!isNew || !texture) return;
        const unsigned size[2] = {texture->width(), texture->height()};
        bytes(size, sizeof size);
        bytes(texture->pixels().data(), texture->pixels().size() * sizeof(Float3));
    }

private:
    int pipe_;
    std::map<const Texture*, std::size_t> numbers_{{nullptr, 0}};
};

class Reader {
public:
    explicit Reader(int pipe) : pipe_(pipe) {}

    void bytes(void* data, std::size_t size) {
        auto* next = static_cast<char*>(data);
        while (size > 0) {
            const ssize_t got = ::read(pipe_, next, size);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) throw std::runtime_error(std::strerror(errno));
            if (got == 0) throw std::runtime_error("the importer ended early");
            next += got;
            size -= static_cast<std::size_t>(got);
        }
    }

    template <typename T>
    void count(T& container) {
        uint64_t size = 0;
        bytes(&size, sizeof size);
        container.resize(size);
    }

    void texture(TexturePtr& texture) {
        std::size_t number = 0;
        bytes(&number, sizeof number);
        if (number == textures_.size()) {
            unsigned size[2];
            bytes(size, sizeof size);
            std::vector<Float3> pixels(std::size_t{size[0]} * size[1]);
            bytes(pixels.data(), pixels.size() * sizeof(Float3));
            textures_.push_back(
                std::make_shared<const Texture>(size[0], size[1], std::move(pixels)));
        }
        texture = textures_.at(number);
    }

private:
    int pipe_;
    std::vector<TexturePtr> textures_{nullptr};
};

/// A Reader fills `T`s, a Writer reads const ones.
template <typename Stream, typename T>
using Of = std::conditional_t<std::is_same_v<Stream, Writer>, const T, T>;

template <typename Stream, typename T>
void transferValue(Stream& stream, T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    stream.bytes(&value, sizeof value);
}

/// Of vectors and strings of plain values.
template <typename Stream, typename T>
void transferArray(Stream& stream, T& array) {
    static_assert(std::is_trivially_copyable_v<typename T::value_type>);
    stream.count(array);
    stream.bytes(array.data(), array.size() * sizeof(typename T::value_type));
}

template <typename Stream>
void transfer(Stream& stream, Of<Stream, TextureMap>& map) {
    stream.texture(map.texture);
    transferValue(stream, map.sampling);
    transferValue(stream, map.transform);
    transferValue(stream, map.takesSecondUv);
}

template <typename Stream>
void transfer(Stream& stream, Of<Stream, Material>& material) {
    transferValue(stream, material.baseColor);
    transferValue(stream, material.metallic);
    transferValue(stream, material.roughness);
    transferValue(stream, material.emission);
    transferValue(stream, material.doubleSided);
    transferValue(stream, material.specularF0);
    transferValue(stream, material.specularColor);
    transfer<Stream>(stream, material.baseColorTexture);
    transfer<Stream>(stream, material.metallicRoughnessTexture);
    transfer<Stream>(stream, material.emissionTexture);
    transfer<Stream>(stream, material.specularColorTexture);
    transfer<Stream>(stream, material.specularTexture);
    transfer<Stream>(stream, material.normalTexture);
    transferValue(stream, material.normalScale);
    transfer<Stream>(stream, material.opacityTexture);
    transferValue(stream, material.opacity);
    transferValue(stream, material.opacityCutoff);
    transferValue(stream, material.alpha);
    transferValue(stream, material.colorIsEmission);
    transferValue(stream, material.transmission);
    transfer<Stream>(stream, material.transmissionTexture);
    transferValue(stream, material.ior);
    transferValue(stream, material.isSolid);
    transferValue(stream, material.absorption);
}

template <typename Stream>
void transfer(Stream& stream, Of<Stream, Mesh>& mesh) {
    transferArray(stream, mesh.positions);
    transferArray(stream, mesh.positionsAtEnd);
    transferArray(stream, mesh.normals);
    transferArray(stream, mesh.uvs);
    transferArray(stream, mesh.secondUvs);
    transferArray(stream, mesh.colors);
    transferArray(stream, mesh.triangles);
    transferValue(stream, mesh.material);
}

template <typename Stream>
void transfer(Stream& stream, Of<Stream, NamedCamera>& camera) {
    transferArray(stream, camera.name);
    transferArray(stream, camera.otherName);
    transferValue(stream, camera.camera);
    transferValue(stream, camera.aspect);
}

template <typename Stream>
void transfer(Stream& stream, Of<Stream, std::optional<Environment>>& environment) {
    bool exists = environment.has_value();
    transferValue(stream, exists);
    if (!exists) return;
    Environment value = environment.value_or(Environment{});
    transferValue(stream, value.radiance);
    stream.texture(value.map);
    if constexpr (std::is_same_v<Stream, Reader>) environment = value;
}

template <typename Stream>
void transfer(Stream& stream, Of<Stream, Scene>& scene) {
    stream.count(scene.materials);
    for (auto& material : scene.materials) transfer<Stream>(stream, material);
    stream.count(scene.meshes);
    for (auto& mesh : scene.meshes) transfer<Stream>(stream, mesh);
    transferArray(stream, scene.spheres);
    transferArray(stream, scene.lights);
    transfer<Stream>(stream, scene.environment);
    stream.count(scene.cameras);
    for (auto& camera : scene.cameras) transfer<Stream>(stream, camera);
    transferValue(stream, scene.camera);
    transferValue(stream, scene.cameraIsAutomatic);
    transferValue(stream, scene.aspect);
    for (auto* texts : {&scene.files, &scene.notes}) {
        stream.count(*texts);
        for (auto& text : *texts) transferArray(stream, text);
    }
}

} // namespace

void sendScene(const Scene& scene, int pipe) {
    Writer writer(pipe);
    sendFailure("", pipe);
    transfer<Writer>(writer, scene);
}

void sendFailure(const std::string& reason, int pipe) {
    Writer writer(pipe);
    transferArray(writer, reason);
}

Scene receiveScene(int pipe) {
    Reader reader(pipe);
    std::string failure;
    transferArray(reader, failure);
    if (!failure.empty()) throw std::runtime_error(failure);
    Scene scene;
    transfer<Reader>(reader, scene);
    return scene;
}

} // namespace wellstrat::render
