// SPDX-License-Identifier: Apache-2.0
//
// What the tool says beside its results. A message that cannot be written is lost, and costs
// nothing else.

#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace wellstrat::cli {

/// Writes `text` to the open file `descriptor`, at once. What cannot be written is lost, also where
/// nobody reads a pipe any more.
void writeMessage(int descriptor, std::string_view text);

/// Writes "wellstrat: TEXT" as one line to the standard error.
void sayText(const std::string& text);

/// The same for a text that is to be formatted.
template <typename... T>
void say(fmt::format_string<T...> format, T&&... values) {
    sayText(fmt::format(format, std::forward<T>(values)...));
}

/// `text` with control characters written as \n, \t or \xNN, so that it prints as one line
/// whatever file names it quotes.
std::string oneLine(std::string_view text);

} // namespace wellstrat::cli
