// SPDX-License-Identifier: Apache-2.0
//
// Banks to test with.

#pragma once

#include "bank_search/partial_bank.h"

#include <cstdint>
#include <random>

namespace bank_tests {

using namespace wellstrat::bank;

/// A matrix that is as random as it may be.
inline Columns randomColumns(std::mt19937& random) {
    Columns columns{};
    for (unsigned k = 0; k < kDigits; ++k) {
        columns[k] = static_cast<uint16_t>(1u << k | random() % (1u << k));
    }
    return columns;
}

inline Bank randomBank(std::size_t slots, uint32_t seed) {
    std::mt19937 random(seed);
    Bank bank;
    while (bank.size() < slots) bank.push_back(randomColumns(random));
    return bank;
}

} // namespace bank_tests
