// SPDX-License-Identifier: Apache-2.0
//
// A bank of which the first columns are chosen, and what these cost.

#pragma once

#include "bank_search/merit.h"

#include <cstddef>
#include <vector>

namespace wellstrat::bank {

using Bank = std::vector<Columns>;

class PartialBank {
public:
    /// No column yet.
    explicit PartialBank(std::size_t slots);

    /// With one column more, for each slot its bits below the diagonal.
    PartialBank extended(const std::vector<uint16_t>& column) const;

    std::size_t slots() const { return bank_.size(); }
    unsigned digits() const { return digits_; } ///< columns so far

    /// Columns not yet chosen are zero.
    const Bank& bank() const { return bank_; }

    /// The images of the first 2^digits() indices.
    const std::vector<uint16_t>& order(std::size_t slot) const { return orders_[slot]; }

    /// The sums of the products of what varies in a pair model, over n < 2^digits(). a > b; the
    /// model's first function is of slot a.
    double pairSum(std::size_t a, std::size_t b, std::size_t model) const {
        return pairSums_[(a * (a - 1) / 2 + b) * pairModels().size() + model];
    }

    /// What all pairs and triples cost with 2^digits() points.
    double price() const;

private:
    void addSums(unsigned begin);

    Bank bank_;
    unsigned digits_ = 0;
    std::vector<std::vector<uint16_t>> orders_;
    std::vector<double> pairSums_;
    std::vector<double> tripleSums_; ///< of the products themselves
};

} // namespace wellstrat::bank
