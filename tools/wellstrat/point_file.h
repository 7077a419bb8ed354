// SPDX-License-Identifier: Apache-2.0
//
// Point sets of other programs: text, NumPy arrays and plain binary numbers.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// Points in [0, 1)^dims, point after point.
struct PointTable {
    std::vector<double> values;
    unsigned dims = 0;

    std::size_t count() const { return values.size() / dims; }
};

/// More points than this are not read.
constexpr std::size_t kMaxFilePoints = std::size_t{1} << 20;

/// What to read, as the command line gives it.
struct PointFileOptions {
    std::string path;                  ///< "-" is the standard input
    std::optional<std::string> format; ///< text, npy or raw; by default what suffix and bytes say
    std::string type = "float32";      ///< of raw numbers: float32 or float64, little-endian
    std::optional<unsigned> dims;      ///< of raw points
};

/// Reads all points. Throws CliError, which names the place and says what is accepted, for a file
/// that cannot be read, that is empty, cut off or ragged, that holds anything but numbers in
/// [0, 1), or more than kMaxFilePoints points. Memory stays bounded by that number whatever the
/// file holds.
PointTable readPoints(const PointFileOptions& options);

} // namespace wellstrat::cli
