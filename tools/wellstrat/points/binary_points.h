// SPDX-License-Identifier: Apache-2.0
//
// Points as binary numbers.

#pragma once

#include "number_type.h"
#include "point_reader.h"

#include <optional>
#include <string_view>

namespace wellstrat::cli {

/// What the bytes of every file of UTK's binary format begin with.
constexpr std::string_view kUtkMagic = "UTK!";

/// Each reads one source and throws CliError. `scale` is what the numbers are multiplied by; none:
/// what their type usually means.

/// Numbers to the end, `dims` for each point. One set.
PatternTable readRawPoints(ByteSource& source, const NumberType& type, unsigned dims,
                           std::optional<double> scale);

/// Arrays of NumPy with the axes (points), (points, coordinates) or (sets, points, coordinates).
PatternTable readNpyPoints(ByteSource& source, std::optional<double> scale);

/// UTK's sets, as https://utk-team.github.io/utk/usingutk/ExeUtk.html describes them under "File
/// formats": five words of 4 bytes, the lowest first, which are the magic number, the type of the
/// numbers, and how many sets, points in each, and dimensions there are; then the numbers, set
/// after set, point after point.
PatternTable readUtkPoints(ByteSource& source, std::optional<double> scale);

} // namespace wellstrat::cli
