// SPDX-License-Identifier: Apache-2.0

#include "errors.h"

#include <fmt/format.h>

#include <iterator>
#include <system_error>

namespace wellstrat::cli {

CliError fileError(std::string_view action, std::string_view path, int errnoValue) {
    return CliError(fmt::format("cannot {} '{}': {}", action, path,
                                std::generic_category().message(errnoValue)));
}

std::string oneLine(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n') {
            line += "\\n";
        } else if (c == '\t') {
            line += "\\t";
        } else if (byte < 0x20 || byte == 0x7f) {
            fmt::format_to(std::back_inserter(line), "\\x{:02x}", byte);
        } else {
            line += c;
        }
    }
    return line;
}

} // namespace wellstrat::cli
