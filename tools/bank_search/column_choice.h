// SPDX-License-Identifier: Apache-2.0
//
// The next column of all slots at once, by looking up what each pair of them costs
// (pair_columns.h).

#pragma once

#include "bank_search/partial_bank.h"

#include <random>
#include <vector>

namespace wellstrat::bank {

/// The bits below the diagonal of one column of each slot, and what they cost.
struct ColumnChoice {
    std::vector<uint16_t> column;
    double price; ///< of all pairs with one slot at least that was free
};

struct ChoiceOptions {
    unsigned attempts; ///< to leave a local minimum
    std::size_t kept;  ///< how many choices are wanted
};

/// The cheapest choices that are found, the best one first. The slots of `fixed` have their columns
/// from there. The same on every machine for the same state of `random`.
std::vector<ColumnChoice> chooseColumns(const PartialBank& bank, const Bank& fixed,
                                        const ChoiceOptions& options, std::mt19937& random);

} // namespace wellstrat::bank
