// SPDX-License-Identifier: Apache-2.0
#include "rank_search/judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wellstrat::ranks {
namespace {

using Pair = std::pair<const Visits*, const Visits*>;

/// The mean and the worst over `pairs`.
std::vector<Judgement> judgePairs(const std::string& what, const Model& model,
                                  const Weights& weights, const std::vector<Pair>& pairs) {
    Judgement mean{what, model.name, "mean", {}}, worst{what, model.name, "worst", {}};
    for (unsigned k = 0; k <= kRunDigits; ++k) {
        const Sums sums = sumsOf(model, k);
        for (const auto& [first, second] : pairs) {
            const double squared = merit(weights, covarianceOf(sums, *first, *second));
            const double ratio = std::sqrt(std::max(squared, 0.0));
            mean.ratios[k] += ratio / static_cast<double>(pairs.size());
            worst.ratios[k] = std::max(worst.ratios[k], ratio);
        }
    }
    if (pairs.size() == 1) return {mean};
    return {mean, worst};
}

} // namespace

std::vector<Judgement> judge(const RankTables& tables) {
    std::vector<Visits> slots;
    for (std::size_t d = 0; d < tables.bank.size(); ++d) {
        slots.push_back(visitsOf(static_cast<unsigned>(d), tables.bank[d]));
    }
    const Visits padded = visitsOf(0, identityColumns());
    std::vector<Pair> ones, pairs;
    for (std::size_t a = 0; a < slots.size(); ++a) {
        ones.emplace_back(&slots[a], &slots[a]);
        for (std::size_t b = 0; b < a; ++b) pairs.emplace_back(&slots[a], &slots[b]);
    }
    const Weights ofPadded = weightsOf(tables.padded, 0), ofSlots = weightsOf(tables.slots, 0);
    std::vector<Judgement> all;
    const auto append = [&all](const std::vector<Judgement>& lines) {
        all.insert(all.end(), lines.begin(), lines.end());
    };
    for (const Model& model : modelsOfOne()) {
        append(judgePairs("padded", model, ofPadded, {{&padded, &padded}}));
    }
    for (const Model& model : modelsOfOne()) append(judgePairs("slot", model, ofSlots, ones));
    for (const Model& model : modelsOfPairs()) append(judgePairs("pair", model, ofSlots, pairs));
    return all;
}

} // namespace wellstrat::ranks
