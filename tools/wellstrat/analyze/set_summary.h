// SPDX-License-Identifier: Apache-2.0
//
// Measures of several sets, one number for each of them, in short.

#pragma once

#include "measures.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

struct SummaryRow {
    std::string measure; ///< such as "t (x, y)" or "L2 star"
    double mean, worst;
    std::string worstSet; ///< the first set that has it
};

/// Mean and worst of t, discrepancies (of bounds the upper ones) and smallest distances; the worst
/// of these is the smallest one. Empty unless sets were measured each by itself.
std::vector<SummaryRow> summaryOf(const Measures& measures);

} // namespace wellstrat::cli
