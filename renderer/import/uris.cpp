// SPDX-License-Identifier: Apache-2.0

#include "uris.h"

#include <cctype>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace wellstrat::render {
namespace {

int hexDigit(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (!std::isxdigit(byte)) return -1;
    return std::isdigit(byte) ? c - '0' : std::tolower(byte) - 'a' + 10;
}

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// RFC 4648, section 4. Padding may be left out.
std::string base64Decoded(std::string_view text) {
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    unsigned count = 0;
    for (const char c : text) {
        const int digit = base64Digit(c);
        if (digit < 0) throw std::runtime_error("its data is not encoded in base64");
        bits = bits << 6 | static_cast<uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    return bytes;
}

} // namespace

std::string percentDecoded(const std::string& uri) {
    std::string text;
    text.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        if (uri[i] == '%' && low >= 0) {
            text += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

std::optional<DataUri> dataOf(const std::string& uri) {
    constexpr std::string_view kScheme = "data:", kBase64 = ";base64";
    if (uri.compare(0, kScheme.size(), kScheme) != 0) return {};
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos) throw std::runtime_error("its data: URI has no comma");
    std::string_view header = std::string_view(uri).substr(kScheme.size(), comma - kScheme.size());
    DataUri data{{}, percentDecoded(uri.substr(comma + 1))};
    if (header.size() >= kBase64.size() &&
        header.substr(header.size() - kBase64.size()) == kBase64) {
        header.remove_suffix(kBase64.size());
        data.bytes = base64Decoded(data.bytes);
    }
    data.mediaType = header.substr(0, header.find(';'));
    return data;
}

} // namespace wellstrat::render
