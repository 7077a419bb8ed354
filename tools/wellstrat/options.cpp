// SPDX-License-Identifier: Apache-2.0

#include "options.h"

#include "errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <filesystem>

namespace wellstrat::cli {

bool parseNumber(std::string_view text, NumberRange range, uint64_t& value) {
    const bool hexadecimal = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
    if (hexadecimal) text.remove_prefix(2);
    const char* const end = text.data() + text.size();
    uint64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, number, hexadecimal ? 16 : 10);
    if (error != std::errc() || stop != end) return false;
    if (number < range.min || number > range.max) return false;
    value = number;
    return true;
}

CLI::Option* addNumber(CLI::App& command, const std::string& flags, uint64_t& value,
                       NumberRange range, const std::string& description) {
    const auto read = [&value, flags, range](const std::string& text) {
        if (parseNumber(text, range, value)) return;
        throw CLI::ValidationError(flags, fmt::format("not a whole number from {} to {}: '{}'",
                                                      range.min, range.max, text));
    };
    return command.add_option_function<std::string>(flags, read, description)->type_name("N");
}

std::string requireSuffix(const std::string& option, const std::string& path,
                          std::initializer_list<const char*> accepted) {
    std::string suffix = std::filesystem::path(path).extension().string();
    for (const char* candidate : accepted) {
        if (suffix == candidate) return suffix;
    }
    throw CliError(fmt::format("{}: the file name must end in one of {}, not '{}'", option,
                               fmt::join(accepted, ", "), path));
}

} // namespace wellstrat::cli
