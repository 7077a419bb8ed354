// SPDX-License-Identifier: Apache-2.0
//
// Point sets of other programs: text, NumPy arrays, UTK's binary files and plain binary numbers,
// all of them compressed by gzip or not.

#pragma once

#include "point_table.h"

#include <optional>
#include <string>

namespace wellstrat::cli {

/// What to read, as the command line gives it.
struct PointFileOptions {
    std::string path;                  ///< "-" is the standard input
    std::optional<std::string> format; ///< text, npy, raw or utk; by default what suffix and bytes
                                       ///< say
    std::string type = "float32";      ///< of raw numbers, little-endian: see number_type.h
    std::optional<unsigned> dims;      ///< of raw points; an error for others
    std::optional<std::string> scale;  ///< what numbers are multiplied by, such as "2^-32"; by
                                       ///< default 1, and 2^-bits for binary unsigned integers
};

/// Reads all points of a file: one pattern, or the sets of an array with three axes, of text with
/// lines of # between them, or of UTK. Throws CliError, which names the place and says what is
/// accepted, for a file that cannot be read, that is empty, cut off or ragged, has sets of
/// different sizes, lacks a value, or holds anything but numbers that are in [0, 1) once scaled,
/// more than kMaxFilePoints points in a set or more than kMaxFileNumbers numbers. Memory stays
/// bounded by these whatever the file holds.
PatternTable readPatterns(const PointFileOptions& options);

} // namespace wellstrat::cli
