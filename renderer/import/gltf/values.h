// SPDX-License-Identifier: Apache-2.0
//
// Members of extensions, which tinygltf keeps as JSON.

#pragma once

#include "wellstrat/vector.h"

#include <tiny_gltf.h>

#include <optional>
#include <string>

namespace wellstrat::render {

/// What an extension says of an object of the file; null if it says nothing.
inline const tinygltf::Value* find(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

/// A member of an object, itself an object or array; null if it is not there.
inline const tinygltf::Value* find(const tinygltf::Value& object, const char* name) {
    return object.Has(name) ? &object.Get(name) : nullptr;
}

inline std::optional<double> numberOf(const tinygltf::Value& object, const char* name) {
    const tinygltf::Value* const value = find(object, name);
    if (!value || !value->IsNumber()) return {};
    return value->GetNumberAsDouble();
}

inline float numberOr(const tinygltf::Value& object, const char* name, float otherwise) {
    return static_cast<float>(numberOf(object, name).value_or(otherwise));
}

/// An index; -1 if there is none.
inline int indexOf(const tinygltf::Value& object, const char* name) {
    const tinygltf::Value* const value = find(object, name);
    return value && value->IsInt() ? value->GetNumberAsInt() : -1;
}

/// The first `size` numbers of an array; `otherwise` if it has not as many.
template <typename Vector>
Vector vectorOr(const tinygltf::Value& object, const char* name, int size, Vector otherwise) {
    const tinygltf::Value* const array = find(object, name);
    if (!array || array->ArrayLen() < static_cast<std::size_t>(size)) return otherwise;
    Vector result = otherwise;
    for (int i = 0; i < size; ++i) {
        if (!array->Get(i).IsNumber()) return otherwise;
        result[i] = static_cast<float>(array->Get(i).GetNumberAsDouble());
    }
    return result;
}

inline Float2 float2Or(const tinygltf::Value& object, const char* name, Float2 otherwise) {
    return vectorOr(object, name, 2, otherwise);
}

inline Float3 float3Or(const tinygltf::Value& object, const char* name, Float3 otherwise) {
    return vectorOr(object, name, 3, otherwise);
}

} // namespace wellstrat::render
