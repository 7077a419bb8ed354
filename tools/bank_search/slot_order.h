// SPDX-License-Identifier: Apache-2.0
//
// The order in which a slot visits the points of a table, as a bit matrix.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace wellstrat::bank {

constexpr unsigned kDigits = 12;
constexpr unsigned kPoints = 1u << kDigits;

/// A unit upper triangular matrix over GF(2): column k is the image of index bit k. It has bit k
/// and no higher one, so that [0, 2^m) is mapped onto itself for each m.
using Columns = std::array<uint16_t, kDigits>;

/// The images of all indices of up to `digits` bits, continued column by column.
inline void appendColumn(std::vector<uint16_t>& order, uint16_t column) {
    const std::size_t half = order.size();
    for (std::size_t i = 0; i < half; ++i) {
        order.push_back(static_cast<uint16_t>(order[i] ^ column));
    }
}

inline std::vector<uint16_t> orderOf(const Columns& columns) {
    std::vector<uint16_t> order{0};
    for (const uint16_t column : columns) appendColumn(order, column);
    return order;
}

/// Pascal's triangle modulo 2 times `index`: where x and y of the first two Sobol' dimensions
/// change places. Its own inverse.
constexpr uint16_t swapAxes(uint16_t index) {
    unsigned j = index;
    j ^= (j & 0xaaaau) >> 1;
    j ^= (j & 0xccccu) >> 2;
    j ^= (j & 0xf0f0u) >> 4;
    j ^= (j & 0xff00u) >> 8;
    return static_cast<uint16_t>(j);
}

} // namespace wellstrat::bank
