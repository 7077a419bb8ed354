// SPDX-License-Identifier: Apache-2.0

#include "text_fields.h"

#include <algorithm>
#include <charconv>

namespace wellstrat::cli {
namespace {

constexpr std::string_view kBlanks = " \t\r";

void skipBlanks(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
}

/// Splits off what stands before one of `separators`, or between quotes.
std::string nextField(std::string_view& line, std::string_view separators) {
    if (!line.empty() && line.front() == '"') {
        const std::size_t end = std::min(line.find('"', 1), line.size());
        std::string field(line.substr(1, end - 1));
        line.remove_prefix(std::min(end + 1, line.size()));
        return field;
    }
    const std::string_view field = line.substr(0, line.find_first_of(separators));
    line.remove_prefix(field.size());
    return std::string(trimmed(field));
}

/// Skips one comma or semicolon with the blanks before it. Was there one?
bool skipComma(std::string_view& line) {
    skipBlanks(line);
    if (line.empty() || (line.front() != ',' && line.front() != ';')) return false;
    line.remove_prefix(1);
    return true;
}

} // namespace

std::string_view trimmed(std::string_view text) {
    skipBlanks(text);
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

bool splitFields(std::string_view line, std::vector<std::string>& fields) {
    fields.clear();
    for (bool afterComma = false;; afterComma = skipComma(line)) {
        skipBlanks(line);
        std::string field = nextField(line, " \t\r,;");
        if (field.empty()) return line.empty() && !afterComma;
        fields.push_back(std::move(field));
    }
}

std::vector<std::string> namesIn(std::string_view line) {
    const auto has = [&](char c) { return line.find(c) != std::string_view::npos; };
    for (const char separator : {',', ';', '\t'}) {
        if (!has(separator)) continue;
        std::vector<std::string> names;
        for (;;) {
            line.remove_prefix(std::min(line.find_first_not_of(" \r"), line.size()));
            names.push_back(nextField(line, {&separator, 1}));
            const std::size_t next = line.find(separator);
            if (next == std::string_view::npos) return names;
            line.remove_prefix(next + 1);
        }
    }
    std::vector<std::string> names;
    splitFields(line, names);
    return names;
}

bool areNames(const std::vector<std::string>& names) {
    if (names.empty()) return false;
    const bool index = names.size() > 1 && names.front().empty();
    return std::all_of(names.begin() + (index ? 1 : 0), names.end(), [&](const std::string& name) {
        return !name.empty() && (!numberOf(name) || (index && countOf(name)));
    });
}

bool isQuoted(std::string_view line) {
    skipBlanks(line);
    return !line.empty() && line.front() == '"';
}

std::optional<double> numberOf(const std::string& field) {
    const std::size_t exponent = field.find_first_of("dD");
    const std::size_t plus = field.size() > 1 && field[0] == '+' && field[1] != '-' ? 1 : 0;
    std::string text = field.substr(plus);
    // Fortran's exponents of double precision: 1.5D-01.
    if (exponent != std::string::npos && exponent > plus) text[exponent - plus] = 'e';
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return {};
    return value;
}

std::optional<std::size_t> countOf(std::string_view field) {
    std::size_t count = 0;
    const char* const end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, count);
    if (error != std::errc() || stop != end) return {};
    return count;
}

std::string shown(std::string_view field) {
    constexpr std::size_t kShown = 40;
    std::string text(field.substr(0, kShown));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

} // namespace wellstrat::cli
