// SPDX-License-Identifier: Apache-2.0

#include "document.h"
#include "../uris.h"
#include "container.h"
#include "extensions.h"
#include "meshopt.h"
#include "values.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestName = 60; // of a URI in a message

Json parsed(std::string_view text) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw std::runtime_error(fmt::format("it is no valid JSON at byte {}", error.byte));
    }
}

/// A member of an object; null if it is not there.
const Json& member(const Json& object, const char* name) {
    static const Json kNull;
    const auto found = object.find(name);
    return object.is_object() && found != object.end() ? *found : kNull;
}

/// What is in a list; nothing if it is none.
const Json& listOf(const Json& object, const char* name) {
    static const Json kEmpty = Json::array();
    const Json& list = member(object, name);
    return list.is_array() ? list : kEmpty;
}

std::string stringOf(const Json& object, const char* name) {
    const Json& value = member(object, name);
    return value.is_string() ? value.get<std::string>() : std::string();
}

int indexOf(const Json& object, const char* name) {
    const Json& value = member(object, name);
    return value.is_number_integer() ? value.get<int>() : -1;
}

std::vector<std::string> namesOf(const Json& object, const char* name) {
    std::vector<std::string> names;
    for (const Json& value : listOf(object, name))
        if (value.is_string()) names.push_back(value.get<std::string>());
    return names;
}

void requireVersion2(const Json& root) {
    const std::string version = stringOf(member(root, "asset"), "version");
    if (version.compare(0, 2, "2.") != 0)
        throw std::runtime_error(version.empty()
                                     ? "it does not say of which version of glTF it is"
                                     : "it is of version " + version + " of glTF, not 2");
}

/// Only those read such a buffer who cannot decompress.
bool isFallback(const Json& buffer) {
    return member(member(member(buffer, "extensions"), kMeshoptExtension), "fallback") == true;
}

/// The bytes that a URI stands for.
std::string fetched(const std::string& uri, FileFinder& files) {
    if (auto data = dataOf(uri)) return std::move(data->bytes);
    return contentOf(files.find(uri));
}

ImageSource imageOf(const Json& image, std::size_t number) {
    ImageSource source;
    source.mimeType = stringOf(image, "mimeType");
    source.bufferView = indexOf(image, "bufferView");
    source.uri = stringOf(image, "uri");
    source.name = stringOf(image, "name");
    if (source.name.empty()) source.name = fmt::format("image {}", number);
    try {
        if (auto data = dataOf(source.uri)) {
            if (source.mimeType.empty()) source.mimeType = data->mediaType;
            source.bytes = std::move(data->bytes);
            source.uri.clear();
        } else if (!source.uri.empty()) {
            source.name = source.uri;
        } else if (source.bufferView < 0) {
            source.problem = "the file does not say where it is";
        }
    } catch (const std::runtime_error& error) {
        source.problem = error.what();
        source.uri.clear();
    }
    return source;
}

/// tinygltf wants a buffer view for the indices, and Draco's primitives need none.
void removeIndicesOfDraco(Json& root) {
    if (listOf(root, "meshes").empty()) return;
    for (Json& mesh : root["meshes"]) {
        if (listOf(mesh, "primitives").empty()) continue;
        for (Json& primitive : mesh["primitives"])
            if (!member(member(primitive, "extensions"), kDracoExtension).is_null())
                primitive.erase("indices");
    }
}

tinygltf::Model modelOf(const Json& root) {
    tinygltf::Model model;
    std::string error, warning;
    const std::string text = root.dump();
    if (!tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                  static_cast<unsigned>(text.size()), ""))
        throw std::runtime_error(error.empty() ? "it is no valid glTF" : error);
    return model;
}

} // namespace

GltfDocument::GltfDocument(const std::string& path, FileFinder& files, Notes& notes)
    : files_(files) {
    const GltfParts parts = gltfParts(storage_.emplace_back(contentOf(path)));
    Json root = parsed(parts.json);
    requireVersion2(root);
    checkExtensions(namesOf(root, "extensionsUsed"), namesOf(root, "extensionsRequired"), notes);
    for (const Json& buffer : listOf(root, "buffers")) {
        const bool isFirst = buffers_.empty();
        const std::string uri = stringOf(buffer, "uri");
        try {
            buffers_.push_back(isFallback(buffer) ? std::string_view()
                               : !uri.empty()     ? storage_.emplace_back(fetched(uri, files_))
                               : isFirst && parts.binary ? *parts.binary
                                                         : std::string_view());
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(fmt::format("buffer {}, '{}': {}", buffers_.size(),
                                                 uri.substr(0, kLongestName), error.what()));
        }
    }
    for (const Json& image : listOf(root, "images"))
        images_.push_back(imageOf(image, images_.size()));
    root.erase("buffers");
    root.erase("images");
    if (kHasDraco) removeIndicesOfDraco(root);
    model_ = modelOf(root);
}

std::string_view GltfDocument::bytes(int buffer, std::size_t offset, std::size_t length,
                                     const std::string& what) const {
    const std::string_view bytes = at(buffers_, buffer, "buffer");
    if (offset > bytes.size() || length > bytes.size() - offset)
        throw std::runtime_error(fmt::format(
            "{} is beyond the end of buffer {}, which has {} bytes", what, buffer, bytes.size()));
    return bytes.substr(offset, length);
}

std::string_view GltfDocument::bufferView(int number) const {
    const tinygltf::BufferView& view = at(model_.bufferViews, number, "buffer view");
    const tinygltf::Value* const extension = find(view.extensions, kMeshoptExtension);
    const std::string what = fmt::format("buffer view {}", number);
    if (!extension) return bytes(view.buffer, view.byteOffset, view.byteLength, what);
    const auto [known, isNew] = decompressed_.try_emplace(number);
    if (isNew) {
        const MeshoptView compressed(*extension);
        known->second = decompressed(
            compressed, bytes(compressed.buffer, compressed.offset, compressed.length, what));
    }
    return known->second;
}

} // namespace wellstrat::render
