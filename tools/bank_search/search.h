// SPDX-License-Identifier: Apache-2.0
//
// A bank of slots: 8, then 16 of them, so that fewer slots are better ones. Each time the
// columns of all new slots are chosen together, one column after the other, by a beam search.

#pragma once

#include "bank_search/partial_bank.h"

#include <array>
#include <functional>

namespace wellstrat::bank {

/// How many slots are there after each step of the search.
constexpr std::array<std::size_t, 2> kSteps{8, 16};

struct SearchOptions {
    uint32_t seed = 12;
    unsigned width = 700;      ///< of the beam for up to 64 points
    unsigned attempts = 100;   ///< to improve one column of one bank
    unsigned digits = kDigits; ///< columns; at least 1. Those beyond are zero
    std::size_t slots = 16;    ///< the first so many, at least 2; they do not depend on the others
};

/// A bank of `slots` slots, of which slot 0 is the identity. The same for the same options on every
/// machine and with any number of threads. Calls `progress` with the part that is done, in [0, 1].
Bank searchBank(const SearchOptions& options, const std::function<void(double)>& progress);

} // namespace wellstrat::bank
