// SPDX-License-Identifier: Apache-2.0

#include "errors.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <iterator>
#include <new>
#include <system_error>

namespace wellstrat::cli {
namespace {

int fail(const char* message) {
    fmt::print(stderr, "wellstrat: {}\n", oneLine(message));
    return kExitError;
}

} // namespace

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

int exitCodeOf(const std::function<int()>& run) {
    try {
        return run();
    } catch (const std::bad_alloc&) {
        return fail("out of memory");
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}

} // namespace wellstrat::cli
