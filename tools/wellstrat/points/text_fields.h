// SPDX-License-Identifier: Apache-2.0
//
// The fields of a line of text, and what they stand for.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::cli {

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The fields of a line, between commas, semicolons or blanks, without their quotes. False if
/// nothing stands beside a comma or semicolon.
bool splitFields(std::string_view line, std::vector<std::string>& fields);

/// The fields of a line as names, which may be empty and hold blanks: between commas; without any,
/// between semicolons; without these, between tabs; without these, between blanks.
std::vector<std::string> namesIn(std::string_view line);

/// Whether these may be the names of columns: none is a number, or the first one, which is none, is
/// followed by anything but fractions, as data frames number columns that have no name.
bool areNames(const std::vector<std::string>& names);

/// Does a line begin with a quoted field?
bool isQuoted(std::string_view line);

/// The number that a whole field is.
std::optional<double> numberOf(const std::string& field);

/// The same of fields that are decimal digits only.
std::optional<std::size_t> countOf(std::string_view field);

/// The start of a field as it may be shown: of other programs' files, which may be no text at all.
std::string shown(std::string_view field);

} // namespace wellstrat::cli
