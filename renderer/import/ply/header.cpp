// SPDX-License-Identifier: Apache-2.0

#include "header.h"
#include "../text_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace wellstrat::render {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr TypeName kTypes[] = {
    {"char", PlyType::int8},      {"uchar", PlyType::uint8},    {"short", PlyType::int16},
    {"ushort", PlyType::uint16},  {"int", PlyType::int32},      {"uint", PlyType::uint32},
    {"float", PlyType::float32},  {"double", PlyType::float64}, {"int8", PlyType::int8},
    {"uint8", PlyType::uint8},    {"int16", PlyType::int16},    {"uint16", PlyType::uint16},
    {"int32", PlyType::int32},    {"uint32", PlyType::uint32},  {"float32", PlyType::float32},
    {"float64", PlyType::float64}};

PlyType typeOf(std::string_view name) {
    const auto* const known = std::find_if(std::begin(kTypes), std::end(kTypes),
                                           [&](const TypeName& type) { return type.name == name; });
    if (known == std::end(kTypes))
        throw std::runtime_error(fmt::format("its header has the unknown type '{}'", name));
    return known->type;
}

PlyFormat formatOf(std::string_view name) {
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::littleEndian;
    if (name == "binary_big_endian") return PlyFormat::bigEndian;
    throw std::runtime_error(fmt::format("its header has the unknown format '{}'", name));
}

class HeaderParser {
public:
    explicit HeaderParser(std::string_view file) : file_(file) {}

    PlyHeader parse() {
        findLineEnd();
        bool hasFormat = false;
        for (;;) {
            TextLines line{std::string(nextLine())};
            if (!line.next()) continue;
            const auto& words = line.words();
            const std::string_view what = words[0];
            if (what == "end_header") break;
            if (what == "format" && words.size() > 1) {
                header_.format = formatOf(words[1]);
                hasFormat = true;
            } else if (what == "comment") {
                header_.comments.emplace_back(line.from(1));
            } else if (what == "element" && words.size() == 3) {
                header_.elements.push_back({std::string(words[1]), countOf(words[2]), {}});
            } else if (what == "property" && !header_.elements.empty()) {
                header_.elements.back().properties.push_back(propertyOf(words));
            } else if (what != "obj_info") {
                failAt(line.from(0));
            }
        }
        if (!hasFormat) throw std::runtime_error("its header has no format");
        header_.end = position_;
        return std::move(header_);
    }

private:
    /// That of the first line is that of all: behind the header, \n may be a value.
    void findLineEnd() {
        lineEnd_ = file_.compare(0, 5, "ply\r\n") == 0 ? "\r\n"
                   : file_.compare(0, 4, "ply\r") == 0 ? "\r"
                                                       : "\n";
        if (nextLine() != "ply") throw std::runtime_error("it does not begin with a line 'ply'");
    }

    std::string_view nextLine() {
        const std::size_t end = file_.find(lineEnd_, position_);
        if (end == std::string_view::npos) throw std::runtime_error("its header has no end");
        const std::string_view line = file_.substr(position_, end - position_);
        position_ = end + lineEnd_.size();
        return line;
    }

    [[noreturn]] static void failAt(std::string_view line) {
        throw std::runtime_error(fmt::format("its header has a line '{}'", line));
    }

    static uint64_t countOf(std::string_view word) {
        uint64_t count = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (error != std::errc() || stop != word.data() + word.size())
            throw std::runtime_error(fmt::format("its header has the count '{}'", word));
        return count;
    }

    /// Of "property TYPE NAME" or "property list TYPE TYPE NAME".
    static PlyProperty propertyOf(const std::vector<std::string_view>& words) {
        if (words.size() == 3) return {std::string(words[2]), typeOf(words[1]), {}};
        if (words.size() == 5 && words[1] == "list")
            return {std::string(words[4]), typeOf(words[3]), typeOf(words[2])};
        failAt(fmt::format("{}", fmt::join(words, " ")));
    }

    std::string_view file_;
    std::string_view lineEnd_;
    std::size_t position_ = 0;
    PlyHeader header_;
};

} // namespace

PlyHeader parsePlyHeader(std::string_view file) { return HeaderParser(file).parse(); }

} // namespace wellstrat::render
