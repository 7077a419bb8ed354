// SPDX-License-Identifier: Apache-2.0
//
// Points as text, as spreadsheets, data frames, NumPy's savetxt, Fortran and UTK write them.

#pragma once

#include "point_reader.h"

#include <optional>

namespace wellstrat::cli {

/// One point a line, its coordinates separated by commas, semicolons or blanks; a line of nothing
/// but # ends a set, and # begins a comment elsewhere. UTF-8, with or without a byte order mark.
/// Numbers may have a plus sign, quotes, and D for the exponent's E.
///
/// The first line may hold names. Then a column that numbers or names the rows is left out: one
/// that has an empty name; one that has no name, beside as many names as other columns; and a first
/// one that counts 0, 1, 2, ... or 1, 2, 3, ... Without names all columns are coordinates.
///
/// `scale` is what the numbers are multiplied by; none: 1. Throws CliError with the number of the
/// line.
PatternTable readTextPoints(ByteSource& source, std::optional<double> scale);

} // namespace wellstrat::cli
