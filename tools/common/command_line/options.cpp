// SPDX-License-Identifier: Apache-2.0

#include "options.h"

#include "errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <charconv>
#include <filesystem>

namespace wellstrat::cli {
namespace {

/// `Value` is a number, or an optional one.
template <typename Value>
CLI::Option* addParsed(CLI::App& command, const std::string& flags, Value& value, NumberRange range,
                       const std::string& description) {
    const auto read = [&value, flags, range](const std::string& text) {
        uint64_t number = 0;
        if (!parseNumber(text, range, number)) {
            throw CLI::ValidationError(flags, fmt::format("not a whole number from {} to {}: '{}'",
                                                          range.min, range.max, text));
        }
        value = number;
    };
    return command.add_option_function<std::string>(flags, read, description)->type_name("N");
}

} // namespace

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

bool parseReal(std::string_view text, RealRange range, double& value) {
    const char* const end = text.data() + text.size();
    double number = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end) return false;
    if (!(number >= range.min && number <= range.max)) return false;
    value = number;
    return true;
}

CLI::Option* addNumber(CLI::App& command, const std::string& flags, uint64_t& value,
                       NumberRange range, const std::string& description) {
    return addParsed(command, flags, value, range, description);
}

CLI::Option* addNumber(CLI::App& command, const std::string& flags, std::optional<uint64_t>& value,
                       NumberRange range, const std::string& description) {
    return addParsed(command, flags, value, range, description);
}

CLI::Option* addReal(CLI::App& command, const std::string& flags, std::optional<double>& value,
                     RealRange range, const std::string& description) {
    const auto read = [&value, flags, range](const std::string& text) {
        double number = 0;
        if (!parseReal(text, range, number)) {
            throw CLI::ValidationError(
                flags, fmt::format("not a number from {} to {}: '{}'", range.min, range.max, text));
        }
        value = number;
    };
    return command.add_option_function<std::string>(flags, read, description)->type_name("X");
}

std::string requireSuffix(const std::string& option, const std::string& path,
                          std::initializer_list<const char*> accepted) {
    std::string suffix = std::filesystem::path(path).extension().string();
    for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* candidate : accepted) {
        if (suffix == candidate) return suffix;
    }
    throw CliError(fmt::format("{}: the file name must end in one of {}, not '{}'", option,
                               fmt::join(accepted, ", "), path));
}

} // namespace wellstrat::cli
