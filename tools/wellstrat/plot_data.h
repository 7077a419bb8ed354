// SPDX-License-Identifier: Apache-2.0
//
// The data file of a plot.

#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace wellstrat::cli {

/// Named sets of lines, with two blank lines between them as gnuplot wants.
class PlotData {
public:
    void begin(const char* set, size_t number) {
        fmt::format_to(std::back_inserter(text_), "{}# {}{}\n", text_.empty() ? "" : "\n\n", set,
                       number);
    }
    template <typename... T>
    void line(fmt::format_string<T...> format, T&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<T>(values)...);
        text_ += '\n';
    }
    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

} // namespace wellstrat::cli
