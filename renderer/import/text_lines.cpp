// SPDX-License-Identifier: Apache-2.0

#include "text_lines.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <system_error>
#include <utility>

namespace wellstrat::render {
namespace {

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool goesOn(std::string_view line) { return !line.empty() && line.back() == '\\'; }

std::string_view withoutComment(std::string_view line) {
    std::size_t hash = line.find('#');
    while (hash != std::string_view::npos && hash > 0 && !isBlank(line[hash - 1]))
        hash = line.find('#', hash + 1);
    return line.substr(0, hash);
}

} // namespace

TextLines::TextLines(std::string text) : text_(std::move(text)) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text_.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0)
        position_ = kByteOrderMark.size();
}

bool TextLines::next() {
    words_.clear();
    while (words_.empty() && position_ < text_.size()) split(line());
    return !words_.empty();
}

std::string_view TextLines::from(std::size_t word) const {
    if (word >= words_.size()) return {};
    const char* const begin = words_[word].data();
    const char* const end = words_.back().data() + words_.back().size();
    return {begin, static_cast<std::size_t>(end - begin)};
}

/// Up to the next end of a line, without the comment.
std::string_view TextLines::physicalLine() {
    const std::size_t begin = position_;
    std::size_t end = begin;
    while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
    const bool isPair = text_.compare(end, 2, "\r\n") == 0;
    position_ = std::min(end + (isPair ? 2 : 1), text_.size());
    return withoutComment(std::string_view(text_).substr(begin, end - begin));
}

std::string_view TextLines::line() {
    std::string_view part = physicalLine();
    if (!goesOn(part)) return part;
    joined_.clear();
    for (; goesOn(part); part = physicalLine()) {
        joined_ += part.substr(0, part.size() - 1);
        joined_ += ' ';
    }
    joined_ += part;
    return joined_;
}

void TextLines::split(std::string_view line) {
    std::size_t end = 0;
    for (;;) {
        std::size_t begin = end;
        while (begin < line.size() && isBlank(line[begin])) ++begin;
        if (begin == line.size()) return;
        end = begin;
        while (end < line.size() && !isBlank(line[end])) ++end;
        words_.push_back(line.substr(begin, end - begin));
    }
}

double numberOf(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc::result_out_of_range && stop == end)
        return std::strtod(std::string(word).c_str(), nullptr); // infinite, or nearly 0
    const bool isNumber = error == std::errc() && stop == end;
    return isNumber ? value : std::numeric_limits<double>::quiet_NaN();
}

} // namespace wellstrat::render
