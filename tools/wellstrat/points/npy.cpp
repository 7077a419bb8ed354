// SPDX-License-Identifier: Apache-2.0

#include "npy.h"

#include "common/command_line/errors.h"

#include <fmt/ranges.h>

#include <charconv>
#include <cstring>
#include <regex>

namespace wellstrat::cli {
namespace {

using ReadBytes = std::function<std::size_t(char*, std::size_t)>;

std::string readExactly(const ReadBytes& read, std::size_t size) {
    std::string bytes(size, '\0');
    if (read(bytes.data(), size) != size) throw CliError("ends within the NumPy header");
    return bytes;
}

std::size_t littleEndian(const std::string& bytes) {
    std::size_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return value;
}

/// The part of the header's dictionary that `pattern` matches in parentheses.
std::string entry(const std::string& dictionary, const char* pattern) {
    std::smatch match;
    if (!std::regex_search(dictionary, match, std::regex(pattern))) {
        throw CliError("has a NumPy header that says no type, order or shape");
    }
    return match[1];
}

std::vector<uint64_t> numbersIn(const std::string& text) {
    std::vector<uint64_t> numbers;
    const std::regex digits("[0-9]+");
    for (std::sregex_iterator at(text.begin(), text.end(), digits), end; at != end; ++at) {
        uint64_t number = 0;
        const std::string found = at->str();
        const char* const last = found.data() + found.size();
        if (std::from_chars(found.data(), last, number).ec != std::errc()) {
            throw CliError("has a NumPy header with a shape out of range");
        }
        numbers.push_back(number);
    }
    return numbers;
}

} // namespace

NpyArray readNpyHeader(const ReadBytes& read) {
    const std::string start = readExactly(read, kNpyMagic.size() + 2);
    if (start.substr(0, kNpyMagic.size()) != kNpyMagic) throw CliError("is no NumPy file");
    // Version 1 has a length of 2 bytes, later ones of 4.
    const std::size_t length =
        littleEndian(readExactly(read, start[kNpyMagic.size()] == 1 ? 2 : 4));
    constexpr std::size_t kMaxLength = 4096;
    if (length > kMaxLength) throw CliError("has a NumPy header that is too long");
    const std::string dictionary = readExactly(read, length);
    NpyArray array;
    array.type = entry(dictionary, "'descr': *'([^']*)'");
    array.fortranOrder = entry(dictionary, "'fortran_order': *(True|False)") == "True";
    array.shape = numbersIn(entry(dictionary, "'shape': *\\(([0-9, ]*)\\)"));
    return array;
}

std::string npyHeader(const std::string& type, std::initializer_list<uint64_t> shape) {
    std::string dictionary =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}", type,
                    fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
    // Magic (6 bytes), version (2), length (2), then the dictionary, padded so that the data starts
    // at a multiple of 64.
    constexpr size_t prefix = 10;
    const size_t padded = (prefix + dictionary.size() + 1 + 63) / 64 * 64 - prefix;
    dictionary.resize(padded - 1, ' ');
    dictionary += '\n';
    std::string header("\x93NUMPY\x01\x00", 8);
    header += static_cast<char>(padded & 0xff);
    header += static_cast<char>(padded >> 8);
    return header + dictionary;
}

void appendLittleEndian(fmt::memory_buffer& out, uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        out.push_back(static_cast<char>((word >> shift) & 0xffu));
    }
}

void appendLittleEndian(fmt::memory_buffer& out, float value) {
    uint32_t word;
    std::memcpy(&word, &value, sizeof word);
    appendLittleEndian(out, word);
}

} // namespace wellstrat::cli
