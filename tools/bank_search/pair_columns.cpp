// SPDX-License-Identifier: Apache-2.0
#include "bank_search/pair_columns.h"

#include "bank_search/walsh.h"

#include <algorithm>
#include <numeric>

namespace wellstrat::bank {

Order inverted(const Order& order) {
    Order inverse(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) inverse[order[i]] = static_cast<uint16_t>(i);
    return inverse;
}

PairColumns::PairColumns(unsigned k) {
    Order identity(std::size_t{1} << k);
    std::iota(identity.begin(), identity.end(), uint16_t{0});
    first_ = transforms(identity, &Product::first);
}

/// Those of the functions that models have on one side, over [2^k, 2^(k+1)).
PairColumns::Transforms PairColumns::transforms(const Order& order, std::size_t Product::*side) {
    Transforms result(levelFunctions().size());
    for (const PairModel& model : pairModels()) {
        for (const Product& term : model.terms) {
            const std::size_t function = term.*side;
            std::vector<float>& transform = result[function];
            if (!transform.empty()) continue;
            const float* const values = levelFunctions()[function].varying.data() + order.size();
            for (const uint16_t t : order) transform.push_back(values[t]);
            walshTransform(transform);
        }
    }
    return result;
}

void PairColumns::addTerms(const PairModel& model, const Transforms& second,
                           std::vector<float>& sums) const {
    std::fill(sums.begin(), sums.end(), 0.0f);
    for (const Product& term : model.terms) {
        const auto weight = static_cast<float>(term.weight);
        const float* const f = first_[term.first].data();
        const float* const g = second[term.second].data();
        for (std::size_t t = 0; t < sums.size(); ++t) sums[t] += weight * f[t] * g[t];
    }
    walshTransform(sums);
}

} // namespace wellstrat::bank
