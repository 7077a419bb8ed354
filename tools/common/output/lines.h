// SPDX-License-Identifier: Apache-2.0
//
// Text that grows by formatted lines.

#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

namespace wellstrat::cli {

class Lines {
public:
    template <typename... T>
    void line(fmt::format_string<T...> format, T&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<T>(values)...);
        text_ += '\n';
    }
    std::string take() { return std::move(text_); }

protected:
    std::string text_;
};

} // namespace wellstrat::cli
