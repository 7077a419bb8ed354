// SPDX-License-Identifier: Apache-2.0
//
// What the sub-commands share in reading their options.

#pragma once

#include <CLI/App.hpp>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace wellstrat::cli {

/// The whole numbers from min to max, both included.
struct NumberRange {
    uint64_t min, max;
};

constexpr uint64_t kMaxWord = 0xffffffffu;

/// Reads `text`, decimal or 0x and hexadecimal digits and nothing else, into `value`. Returns
/// whether that worked and the number is in `range`; if not, `value` is unchanged.
bool parseNumber(std::string_view text, NumberRange range, uint64_t& value);

/// Adds an option that takes one number of `range`. The current `value` is the default;
/// `value` must outlive `command`.
CLI::Option* addNumber(CLI::App& command, const std::string& flags, uint64_t& value,
                       NumberRange range, const std::string& description);

/// The same for a number that need not be given and has no default.
CLI::Option* addNumber(CLI::App& command, const std::string& flags, std::optional<uint64_t>& value,
                       NumberRange range, const std::string& description);

/// The numbers from min to max, both included.
struct RealRange {
    double min, max;
};

/// Reads `text`, a decimal number and nothing else, into `value`. Returns whether that worked and
/// the number is in `range`; if not, `value` is unchanged.
bool parseReal(std::string_view text, RealRange range, double& value);

/// Adds an option that takes one decimal number of `range`.
CLI::Option* addReal(CLI::App& command, const std::string& flags, std::optional<double>& value,
                     RealRange range, const std::string& description);

/// The one of `accepted`, such as ".png", that the file name `path` ends in, in upper or lower
/// case. Throws CliError, which names `option` and what is accepted, if there is none.
std::string requireSuffix(const std::string& option, const std::string& path,
                          std::initializer_list<const char*> accepted);

} // namespace wellstrat::cli
