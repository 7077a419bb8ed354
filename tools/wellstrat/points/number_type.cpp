// SPDX-License-Identifier: Apache-2.0

#include "number_type.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace wellstrat::cli {
namespace {

using Kind = NumberType::Kind;

/// The bits and bytes of numbers.
constexpr std::pair<std::string_view, unsigned> kWidths[] = {
    {"8", 1}, {"16", 2}, {"32", 4}, {"64", 8}};

template <class Real, class Bits>
double realOf(Bits bits) {
    static_assert(sizeof(Real) == sizeof(Bits));
    Real value;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
}

/// IEEE 754-2008, 3.4: a sign, 5 bits of exponent with a bias of 15, and 10 of fraction.
double halfOf(uint64_t bits) {
    const double sign = (bits >> 15 & 1u) != 0 ? -1 : 1;
    const int exponent = static_cast<int>(bits >> 10 & 31u);
    const auto fraction = static_cast<double>(bits & 1023u);
    if (exponent == 31) {
        if (fraction != 0) return std::numeric_limits<double>::quiet_NaN();
        return sign * std::numeric_limits<double>::infinity();
    }
    if (exponent == 0) return sign * std::ldexp(fraction, -24);
    return sign * std::ldexp(1024 + fraction, exponent - 25);
}

double unsignedOf(uint64_t bits) {
    constexpr uint64_t kExact = uint64_t{1} << 53, kLastBits = (1u << 11) - 1;
    return static_cast<double>(bits < kExact ? bits : bits & ~kLastBits);
}

double signedOf(uint64_t bits, unsigned width) {
    const uint64_t sign = uint64_t{1} << (width - 1);
    if ((bits & sign) == 0) return unsignedOf(bits);
    // Two's complement: the distance to 2^width.
    return -unsignedOf((sign - 1 - (bits & (sign - 1))) + 1);
}

std::optional<NumberType> numberType(char kind, unsigned bytes, bool bigEndian) {
    const bool power = bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
    if (!power || (kind == 'f' && bytes == 1)) return {};
    switch (kind) {
    case 'f': return NumberType{Kind::floating, bytes, bigEndian};
    case 'u': return NumberType{Kind::unsignedInteger, bytes, bigEndian};
    case 'i': return NumberType{Kind::signedInteger, bytes, bigEndian};
    default: return {};
    }
}

} // namespace

double NumberType::decode(const char* from) const {
    uint64_t bits = 0;
    for (unsigned i = 0; i < bytes; ++i) {
        const auto byte = static_cast<unsigned char>(from[bigEndian ? i : bytes - 1 - i]);
        bits = bits << 8 | byte;
    }
    if (kind == Kind::unsignedInteger) return unsignedOf(bits);
    if (kind == Kind::signedInteger) return signedOf(bits, 8 * bytes);
    switch (bytes) {
    case 2: return halfOf(bits);
    case 4: return realOf<float>(static_cast<uint32_t>(bits));
    default: return realOf<double>(bits);
    }
}

std::optional<double> NumberType::usualScale() const {
    switch (kind) {
    case Kind::floating: return 1;
    case Kind::unsignedInteger: return std::ldexp(1.0, -static_cast<int>(8 * bytes));
    default: return {};
    }
}

std::optional<NumberType> numberTypeOfNumpy(std::string_view name) {
    if (name.size() != 3) return {};
    const char order = name[0];
    const auto bytes = static_cast<unsigned>(name[2] - '0');
    const bool ordered = order == '<' || order == '>';
    if (!ordered && !(order == '|' && bytes == 1)) return {};
    return numberType(name[1], bytes, order == '>');
}

std::optional<NumberType> numberTypeNamed(std::string_view name) {
    const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
    const std::string_view word = name.substr(0, digits), bits = name.substr(digits);
    if (word != "float" && word != "uint" && word != "int") return {};
    for (const auto& [text, bytes] : kWidths) {
        if (bits == text) return numberType(word.front(), bytes, false);
    }
    return {};
}

} // namespace wellstrat::cli
