// SPDX-License-Identifier: Apache-2.0
//
// The NumPy file format, and the byte order of everything binary that the tool writes.
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace wellstrat::cli {

/// What precedes the data of a .npy file, version 1.0, of an array in C order. `type` is NumPy's
/// name, such as "<f4" for little-endian 32-bit floats.
std::string npyHeader(const std::string& type, std::initializer_list<uint64_t> shape);

/// What the bytes of every .npy file begin with.
constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// What the header of a .npy file says of the array.
struct NpyArray {
    std::string type; ///< NumPy's name, as above
    bool fortranOrder = false;
    std::vector<uint64_t> shape;
};

/// Reads a header up to the data. `read(to, size)` reads up to `size` bytes and returns how many;
/// less only at the end. Throws CliError, which names no file, if that is no such header.
NpyArray readNpyHeader(const std::function<std::size_t(char*, std::size_t)>& read);

/// Appends 4 bytes, the lowest first, on any machine.
void appendLittleEndian(fmt::memory_buffer& out, uint32_t word);

/// The same for the bits of a float.
void appendLittleEndian(fmt::memory_buffer& out, float value);

} // namespace wellstrat::cli
