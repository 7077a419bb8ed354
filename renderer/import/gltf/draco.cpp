// SPDX-License-Identifier: Apache-2.0

#include "draco.h"
#include "values.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#if WELLSTRAT_DRACO
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#endif

namespace wellstrat::render {
namespace {

[[noreturn]] void fail(std::string_view reason) {
    throw std::runtime_error(fmt::format("{}: {}", kDracoExtension, reason));
}

#if WELLSTRAT_DRACO

/// Is this attribute of integers that mean fractions? The accessor says so.
bool isNormalized(const GltfDocument& document, const tinygltf::Primitive& primitive,
                  const std::string& name) {
    const auto accessor = primitive.attributes.find(name);
    return accessor != primitive.attributes.end() &&
           at(document.model().accessors, accessor->second, "accessor").normalized;
}

Numbers numbersOf(const draco::Mesh& mesh, draco::PointAttribute& attribute, bool normalized) {
    attribute.set_normalized(normalized);
    const auto components = static_cast<int8_t>(attribute.num_components());
    Numbers numbers;
    numbers.components = attribute.num_components();
    numbers.values.resize(mesh.num_points() * numbers.components);
    for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
        float* const values = &numbers.values[i.value() * numbers.components];
        if (!attribute.ConvertValue<float>(attribute.mapped_index(i), components, values))
            fail("an attribute cannot be decoded");
        if (normalized) // the most negative integer counts as the next one
            std::transform(values, values + components, values,
                           [](float v) { return std::max(v, -1.0f); });
    }
    return numbers;
}

#endif

} // namespace

#if WELLSTRAT_DRACO

DracoPrimitive decodeDraco(const GltfDocument& document, const tinygltf::Primitive& primitive) {
    const tinygltf::Value& extension = *find(primitive.extensions, kDracoExtension);
    const std::string_view bytes = document.bufferView(indexOf(extension, "bufferView"));
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) fail(decoded.status().error_msg_string());
    draco::Mesh& mesh = *decoded.value();

    DracoPrimitive result;
    const tinygltf::Value* const attributes = find(extension, "attributes");
    if (!attributes) fail("it names no attributes");
    for (const std::string& name : attributes->Keys()) {
        const int id = indexOf(*attributes, name.c_str());
        const int place = id < 0 ? -1 : mesh.GetAttributeIdByUniqueId(static_cast<uint32_t>(id));
        if (place < 0) fail("an attribute that it names is not there");
        result.attributes[name] =
            numbersOf(mesh, *mesh.attribute(place), isNormalized(document, primitive, name));
    }
    for (draco::FaceIndex i(0); i < mesh.num_faces(); ++i)
        for (const draco::PointIndex& corner : mesh.face(i))
            result.corners.push_back(corner.value());
    return result;
}

#else

DracoPrimitive decodeDraco(const GltfDocument&, const tinygltf::Primitive&) {
    fail("this program was built without Draco");
}

#endif

} // namespace wellstrat::render
