// SPDX-License-Identifier: Apache-2.0
//
// What ranks leave of the error of each model, after the filter.

#pragma once

#include "rank_search/search.h"

#include <array>
#include <string>
#include <vector>

namespace wellstrat::ranks {

/// One line: root mean squared errors after a Gaussian of sigma 2 pixels, as ratios to those of
/// independent pixels with padded domains.
struct Judgement {
    std::string what;                          ///< "padded", "slot" or "pair"
    std::string model;                         ///< its name
    std::string statistic;                     ///< "mean" or "worst": over all slots or pairs
    std::array<double, kRunDigits + 1> ratios; ///< with 2^k samples a pixel
};

/// For each model; the bank has two slots or more.
std::vector<Judgement> judge(const RankTables& tables);

} // namespace wellstrat::ranks
