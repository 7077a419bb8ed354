// SPDX-License-Identifier: Apache-2.0

#include "accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace wellstrat::render {
namespace {

/// No index reaches farther.
constexpr std::size_t kMostElements = std::size_t{1} << 32;

template <typename T>
T valueAt(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// glTF 2.0 specification, section 3.6.2.2, "Accessor Data Types": the most negative integer counts
/// as the next one.
template <typename T>
float fraction(T value) {
    constexpr auto kLargest = static_cast<float>(std::numeric_limits<T>::max());
    return std::max(static_cast<float>(value) / kLargest, -1.0f);
}

template <typename T>
float floatAt(const char* bytes, bool normalized) {
    const T value = valueAt<T>(bytes);
    if constexpr (std::is_integral_v<T>)
        if (normalized) return fraction(value);
    return static_cast<float>(value);
}

float componentAt(const char* bytes, int type, bool normalized) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return floatAt<int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return floatAt<uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return floatAt<int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return floatAt<uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return floatAt<uint32_t>(bytes, normalized);
    default: return floatAt<float>(bytes, false);
    }
}

uint32_t indexAt(const char* bytes, int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return valueAt<uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return valueAt<uint16_t>(bytes);
    default: return valueAt<uint32_t>(bytes);
    }
}

bool isIndexType(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Elements in a buffer view, at equal distances.
struct Elements {
    const char* first;
    std::size_t stride;

    const char* operator[](std::size_t i) const { return first + i * stride; }
};

/// `count` elements of `size` bytes, from `offset` on. Throws if the view has not so many.
Elements elementsOf(const GltfDocument& document, int view, std::size_t offset, std::size_t count,
                    std::size_t size, const std::string& what) {
    const std::string_view bytes = document.bufferView(view);
    std::size_t stride = document.model().bufferViews[static_cast<std::size_t>(view)].byteStride;
    if (stride == 0) stride = size;
    const bool fits = offset <= bytes.size() &&
                      (count == 0 || (bytes.size() - offset >= size &&
                                      (bytes.size() - offset - size) / stride >= count - 1));
    if (!fits)
        throw std::runtime_error(
            fmt::format("{} has {} elements, more than buffer view {} holds", what, count, view));
    return {bytes.data() + offset, stride};
}

/// An accessor, checked but for its size.
struct Source {
    Source(const GltfDocument& document, int number)
        : accessor(at(document.model().accessors, number, "accessor")),
          what(fmt::format("accessor {}", number)) {
        const int bytes =
            tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType));
        const int numbers = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
        if (bytes < 1 || bytes > 4 || numbers < 1 || accessor.count > kMostElements ||
            accessor.componentType == TINYGLTF_COMPONENT_TYPE_INT)
            throw std::runtime_error(what + " has a type or a count that glTF does not have");
        componentSize = static_cast<std::size_t>(bytes);
        components = static_cast<std::size_t>(numbers);
    }

    const tinygltf::Accessor& accessor;
    std::string what;
    std::size_t componentSize = 0, components = 0;
};

/// Calls take(i, bytes) for each element i that is not all zeros, sparse ones last.
template <typename Take>
void forEachElement(const GltfDocument& document, const Source& source, Take take) {
    const tinygltf::Accessor& accessor = source.accessor;
    const std::size_t size = source.componentSize * source.components;
    if (accessor.bufferView >= 0) {
        const Elements elements = elementsOf(document, accessor.bufferView, accessor.byteOffset,
                                             accessor.count, size, source.what);
        for (std::size_t i = 0; i < accessor.count; ++i) take(i, elements[i]);
    }
    if (!accessor.sparse.isSparse) return;
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        !isIndexType(sparse.indices.componentType))
        throw std::runtime_error(source.what + " has sparse values that glTF does not have");
    const auto count = static_cast<std::size_t>(sparse.count);
    const auto indexSize = static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(sparse.indices.componentType)));
    const Elements places = elementsOf(document, sparse.indices.bufferView,
                                       static_cast<std::size_t>(sparse.indices.byteOffset), count,
                                       indexSize, source.what);
    const Elements values =
        elementsOf(document, sparse.values.bufferView,
                   static_cast<std::size_t>(sparse.values.byteOffset), count, size, source.what);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = indexAt(places[i], sparse.indices.componentType);
        if (place >= accessor.count)
            throw std::runtime_error(source.what + " has a sparse value beyond its end");
        take(place, values[i]);
    }
}

} // namespace

Numbers readNumbers(const GltfDocument& document, int number) {
    const Source source(document, number);
    Numbers numbers;
    numbers.components = source.components;
    numbers.values.resize(source.accessor.count * source.components);
    forEachElement(document, source, [&](std::size_t i, const char* bytes) {
        for (std::size_t c = 0; c < source.components; ++c)
            numbers.values[i * source.components + c] =
                componentAt(bytes + c * source.componentSize, source.accessor.componentType,
                            source.accessor.normalized);
    });
    return numbers;
}

std::vector<uint32_t> readIndices(const GltfDocument& document, int number) {
    const Source source(document, number);
    if (!isIndexType(source.accessor.componentType) || source.components != 1)
        throw std::runtime_error(source.what + " has no indices in it");
    std::vector<uint32_t> indices(source.accessor.count);
    forEachElement(document, source, [&](std::size_t i, const char* bytes) {
        indices[i] = indexAt(bytes, source.accessor.componentType);
    });
    return indices;
}

} // namespace wellstrat::render
