// SPDX-License-Identifier: Apache-2.0

#include "values.h"
#include "../text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace wellstrat::render {
namespace {

/// Of this machine: the bytes of files are in its order, or in the other.
bool isLittleEndian() {
    const uint16_t one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

[[noreturn]] void failAtEnd() { throw std::runtime_error("it ends before its last value"); }

} // namespace

template <typename T>
double PlyValues::nextBinary() {
    char bytes[sizeof(T)];
    if (most() < sizeof bytes) failAtEnd();
    std::memcpy(bytes, bytes_.data() + position_, sizeof bytes);
    position_ += sizeof bytes;
    if ((format_ == PlyFormat::littleEndian) != isLittleEndian())
        std::reverse(bytes, bytes + sizeof bytes);
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

double PlyValues::nextWord() {
    while (position_ < bytes_.size() && isBlank(bytes_[position_])) ++position_;
    const std::size_t begin = position_;
    while (position_ < bytes_.size() && !isBlank(bytes_[position_])) ++position_;
    if (position_ == begin) failAtEnd();
    return numberOf(bytes_.substr(begin, position_ - begin));
}

double PlyValues::next(PlyType type) {
    if (format_ == PlyFormat::ascii) return nextWord();
    switch (type) {
    case PlyType::int8: return nextBinary<int8_t>();
    case PlyType::uint8: return nextBinary<uint8_t>();
    case PlyType::int16: return nextBinary<int16_t>();
    case PlyType::uint16: return nextBinary<uint16_t>();
    case PlyType::int32: return nextBinary<int32_t>();
    case PlyType::uint32: return nextBinary<uint32_t>();
    case PlyType::float32: return nextBinary<float>();
    case PlyType::float64: return nextBinary<double>();
    }
    return 0;
}

std::size_t PlyValues::nextLength(PlyType type) {
    const double length = next(type);
    if (!(length >= 0) || length != std::floor(length))
        throw std::runtime_error(fmt::format("it has a list of length {}", length));
    if (length > static_cast<double>(most())) failAtEnd();
    return static_cast<std::size_t>(length);
}

} // namespace wellstrat::render
