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

/// Sets of equally many points, such as the randomizations of one sequence, set after set.
struct PatternTable {
    PointTable points;
    std::size_t patterns = 1;

    std::size_t pointsEach() const { return points.count() / patterns; }
};

/// More points than this are not read as one set,
constexpr std::size_t kMaxFilePoints = std::size_t{1} << 20;
/// and of several sets not more numbers.
constexpr std::size_t kMaxPatternNumbers = std::size_t{1} << 25;

/// What to read, as the command line gives it.
struct PointFileOptions {
    std::string path;                  ///< "-" is the standard input
    std::optional<std::string> format; ///< text, npy or raw; by default what suffix and bytes say
    std::string type = "float32";      ///< of raw numbers: float32 or float64, little-endian
    std::optional<unsigned> dims;      ///< of raw points; an error for others
};

/// Reads all points of a file: one pattern, or in a NumPy array with the axes (patterns, points,
/// coordinates) several. Throws CliError, which names the place and says what is accepted, for a
/// file that cannot be read, that is empty, cut off or ragged, lacks a value, that holds anything
/// but numbers in [0, 1), or more than kMaxFilePoints points, or of several patterns more than
/// kMaxPatternNumbers numbers. Memory stays bounded by these whatever the file holds.
PatternTable readPatterns(const PointFileOptions& options);

} // namespace wellstrat::cli
