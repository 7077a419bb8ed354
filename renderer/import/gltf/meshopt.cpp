// SPDX-License-Identifier: Apache-2.0

#include "meshopt.h"
#include "values.h"

#include <fmt/format.h>

#include <stdexcept>

#if WELLSTRAT_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace wellstrat::render {
namespace {

[[noreturn]] void fail(const char* reason) {
    throw std::runtime_error(fmt::format("{}: {}", kMeshoptExtension, reason));
}

/// A size or place in bytes. tinygltf has it as an int.
std::size_t sizeOf(const tinygltf::Value& extension, const char* name, int otherwise) {
    const int size = extension.Has(name) ? indexOf(extension, name) : otherwise;
    if (size < 0) fail("a number is missing, negative, or too large");
    return static_cast<std::size_t>(size);
}

std::string stringOr(const tinygltf::Value& extension, const char* name, const char* otherwise) {
    const tinygltf::Value* const value = find(extension, name);
    return value && value->IsString() ? value->Get<std::string>() : otherwise;
}

#if WELLSTRAT_MESHOPTIMIZER

void filter(const MeshoptView& view, std::string& data) {
    const bool isOct = view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8);
    if (isOct)
        meshopt_decodeFilterOct(data.data(), view.count, view.stride);
    else if (view.filter == "QUATERNION" && view.stride == 8)
        meshopt_decodeFilterQuat(data.data(), view.count, view.stride);
    else if (view.filter == "EXPONENTIAL" && view.stride % 4 == 0)
        meshopt_decodeFilterExp(data.data(), view.count, view.stride);
    else if (view.filter != "NONE")
        fail("its filter is not known, or does not fit its stride");
}

#endif

} // namespace

MeshoptView::MeshoptView(const tinygltf::Value& extension)
    : buffer(indexOf(extension, "buffer")), offset(sizeOf(extension, "byteOffset", 0)),
      length(sizeOf(extension, "byteLength", -1)), stride(sizeOf(extension, "byteStride", -1)),
      count(sizeOf(extension, "count", -1)), mode(stringOr(extension, "mode", "")),
      filter(stringOr(extension, "filter", "NONE")) {}

#if WELLSTRAT_MESHOPTIMIZER

std::string decompressed(const MeshoptView& view, std::string_view compressed) {
    const auto* const from = reinterpret_cast<const unsigned char*>(compressed.data());
    const bool isIndex = view.stride == 2 || view.stride == 4;
    std::string data(view.stride * view.count, '\0');
    int result = -1;
    if (view.mode == "ATTRIBUTES" && view.stride > 0 && view.stride <= 256 && view.stride % 4 == 0)
        result = meshopt_decodeVertexBuffer(data.data(), view.count, view.stride, from,
                                            compressed.size());
    else if (view.mode == "TRIANGLES" && isIndex && view.count % 3 == 0)
        result = meshopt_decodeIndexBuffer(data.data(), view.count, view.stride, from,
                                           compressed.size());
    else if (view.mode == "INDICES" && isIndex)
        result = meshopt_decodeIndexSequence(data.data(), view.count, view.stride, from,
                                             compressed.size());
    else
        fail("its mode is not known, or does not fit its stride and count");
    if (result != 0) fail("the data cannot be decoded");
    filter(view, data);
    return data;
}

#else

std::string decompressed(const MeshoptView&, std::string_view) {
    fail("this program was built without meshoptimizer");
}

#endif

} // namespace wellstrat::render
