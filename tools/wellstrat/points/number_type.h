// SPDX-License-Identifier: Apache-2.0
//
// Kinds of binary numbers in point files.

#pragma once

#include <optional>
#include <string_view>

namespace wellstrat::cli {

/// Floating-point numbers of 2, 4 or 8 bytes (IEEE 754), or integers of 1, 2, 4 or 8.
struct NumberType {
    enum class Kind { floating, unsignedInteger, signedInteger };

    Kind kind;
    unsigned bytes;
    bool bigEndian = false;

    /// The number that starts at `from`. Integers beyond 2^53 lose their last 11 bits: they are
    /// rounded toward 0, so that 2^64 - 1 stays below 2^64.
    double decode(const char* from) const;

    /// What makes coordinates of the numbers: 1 for floating-point ones; 2^-bits for unsigned
    /// integers, which are taken for binary digits; none for signed ones, which could mean either
    /// 2^-bits or twice that.
    std::optional<double> usualScale() const;
};

/// The type that NumPy calls `name`, such as "<f4" or "|u1"; none if it is not among the above.
std::optional<NumberType> numberTypeOfNumpy(std::string_view name);

/// The little-endian type of that name.
std::optional<NumberType> numberTypeNamed(std::string_view name);

/// What `numberTypeNamed` knows, for messages.
constexpr const char* kNumberTypeNames =
    "float16, float32, float64, uint8, uint16, uint32, uint64, int8, int16, int32, int64";

} // namespace wellstrat::cli
