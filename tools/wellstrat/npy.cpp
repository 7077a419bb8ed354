// SPDX-License-Identifier: Apache-2.0

#include "npy.h"

#include <fmt/ranges.h>

#include <cstring>

namespace wellstrat::cli {

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
