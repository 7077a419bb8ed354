// SPDX-License-Identifier: Apache-2.0
//
// The header of a PLY file, which says what follows: Turk 1994, "The PLY Polygon File Format",
// http://paulbourke.net/dataformats/ply/.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::render {

enum class PlyFormat : uint8_t { ascii, littleEndian, bigEndian };

enum class PlyType : uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type; ///< of a list: of its values
    std::optional<PlyType>
        countType; ///< of a list: of the number of its values, which is before them
};

/// Things of one kind, of which each has all properties.
struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> comments;
    std::size_t end = 0; ///< where in the file the values begin
};

/// Throws std::runtime_error with one line that says what in the header is wrong.
PlyHeader parsePlyHeader(std::string_view file);

} // namespace wellstrat::render
