// SPDX-License-Identifier: Apache-2.0
//
// A choice among many by weights, in logarithmic time, that leaves the sample fit for use again.
// RixChooseAndRemap does the same for few weights that change from call to call.

#pragma once

#include "wellstrat/warp.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wellstrat::render {

class DiscreteDistribution {
public:
    /// Weights are finite and at least 0. If they are all 0, nothing may be chosen.
    explicit DiscreteDistribution(const std::vector<double>& weights = {}) {
        ends_.reserve(weights.size());
        for (const double weight : weights) ends_.push_back(total_ += weight);
    }

    /// The sum of the weights.
    double total() const { return total_; }

    std::size_t size() const { return ends_.size(); }

    /// Chooses i with probability(i), for xi in [0, 1), and stretches the part of [0, 1) that was
    /// chosen over [0, 1) again: Shirley et al. 1996, "Monte Carlo Techniques for Direct Lighting
    /// Calculations", ACM TOG 15(1). What has weight 0 is never chosen. total() must be above 0.
    std::size_t choose(float& xi) const {
        const double position = xi * total_;
        const auto end = std::upper_bound(ends_.begin(), ends_.end(), position);
        const auto chosen = static_cast<std::size_t>(end - ends_.begin());
        const double stretched = (position - begin(chosen)) / (ends_[chosen] - begin(chosen));
        xi = std::min(static_cast<float>(stretched), kLargestSample);
        return chosen;
    }

    /// With which `choose` returns i; 0 if all weights are 0.
    double probability(std::size_t i) const {
        return total_ > 0.0 ? (ends_[i] - begin(i)) / total_ : 0.0;
    }

private:
    static constexpr float kLargestSample = 1.0f - 0x1p-24f;

    double begin(std::size_t i) const { return i == 0 ? 0.0 : ends_[i - 1]; }

    std::vector<double> ends_; ///< running sums
    double total_ = 0.0;
};

} // namespace wellstrat::render
