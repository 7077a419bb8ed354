// SPDX-License-Identifier: Apache-2.0
//
// The NumPy file format, and the byte order of everything binary that the tool writes.
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html

#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <initializer_list>
#include <string>

namespace wellstrat::cli {

/// What precedes the data of a .npy file, version 1.0, of an array in C order. `type` is NumPy's
/// name, such as "<f4" for little-endian 32-bit floats.
std::string npyHeader(const std::string& type, std::initializer_list<uint64_t> shape);

/// Appends 4 bytes, the lowest first, on any machine.
void appendLittleEndian(fmt::memory_buffer& out, uint32_t word);

/// The same for the bits of a float.
void appendLittleEndian(fmt::memory_buffer& out, float value);

} // namespace wellstrat::cli
