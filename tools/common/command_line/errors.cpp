// SPDX-License-Identifier: Apache-2.0

#include "errors.h"

#include "messages.h"

#include <fmt/format.h>

#include <new>
#include <system_error>

namespace wellstrat::cli {
CliError fileError(std::string_view action, std::string_view path, int errnoValue) {
    return CliError(fmt::format("cannot {} '{}': {}", action, path,
                                std::generic_category().message(errnoValue)));
}

std::string messageOf(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : error.what();
}

int exitCodeOf(const std::function<int()>& run) {
    try {
        return run();
    } catch (const std::exception& error) {
        sayText(messageOf(error));
        return kExitError;
    }
}

} // namespace wellstrat::cli
