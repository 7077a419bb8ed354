// SPDX-License-Identifier: Apache-2.0
//
// The order in which a slot visits the points of a table, as a bit matrix.

#pragma once

#include "wellstrat/joint_bank.h"
#include "wellstrat/tables.h"

#include <array>
#include <cstdint>
#include <vector>

namespace wellstrat::bank {

constexpr unsigned kDigits = kJointBankDigits;
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

/// The images of the first 2^digits indices.
inline std::vector<uint16_t> orderOf(const Columns& columns, unsigned digits = kDigits) {
    std::vector<uint16_t> order{0};
    for (unsigned k = 0; k < digits; ++k) appendColumn(order, columns[k]);
    return order;
}

} // namespace wellstrat::bank
