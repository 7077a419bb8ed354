// SPDX-License-Identifier: Apache-2.0

#include "container.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace wellstrat::render {
namespace {

// A header of three words (magic, version, length of the file), then chunks, each with a header of
// two words (length of its data, type); the first is the JSON.
constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;
constexpr uint64_t kBinaryChunk = 0x004e4942;

/// 32 bits, least significant byte first.
uint64_t wordAt(std::string_view bytes, std::size_t offset) {
    uint64_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return word;
}

/// The data of the chunk at the beginning of `bytes`.
std::string_view chunkOf(std::string_view bytes) {
    if (bytes.size() < kChunkHeader || bytes.size() - kChunkHeader < wordAt(bytes, 0))
        throw std::runtime_error("the file is shorter than its header says");
    return bytes.substr(kChunkHeader, wordAt(bytes, 0));
}

} // namespace

GltfParts gltfParts(std::string_view bytes) {
    if (bytes.substr(0, 4) != "glTF") {
        if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.remove_prefix(3); // a byte order mark
        return {bytes, {}};
    }
    if (bytes.size() < kFileHeader + kChunkHeader || bytes.size() < wordAt(bytes, 8))
        throw std::runtime_error("the file is shorter than its header says");
    if (wordAt(bytes, 4) != 2)
        throw std::runtime_error(
            fmt::format("it is of version {} of the binary format, not 2", wordAt(bytes, 4)));
    GltfParts parts{chunkOf(bytes.substr(kFileHeader)), {}};
    const std::string_view rest = bytes.substr(kFileHeader + kChunkHeader + parts.json.size());
    if (rest.size() >= kChunkHeader && wordAt(rest, 4) == kBinaryChunk)
        parts.binary = chunkOf(rest);
    return parts;
}

} // namespace wellstrat::render
