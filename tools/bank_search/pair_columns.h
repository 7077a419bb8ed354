// SPDX-License-Identifier: Apache-2.0
//
// What one more column adds to the errors of a pair of slots U and V, for all columns c of U and d
// of V. It depends on one number, c XOR U V^-1 d, since
//
//     sum over n in [2^k, 2^(k+1)) of F(U n) G(V n)
//         = sum over t < 2^k of F(2^k + (t XOR c XOR U V^-1 d)) G(2^k + V U^-1 t),
//
// a convolution: a Walsh-Hadamard transform for each model gives all of it.

#pragma once

#include "bank_search/merit.h"

#include <cstdint>
#include <vector>

namespace wellstrat::bank {

/// The images of indices, or where they come from.
using Order = std::vector<uint16_t>;

Order inverted(const Order& order);

class PairColumns {
public:
    /// For column k, the (k+1)-th.
    explicit PairColumns(unsigned k);

    /// Calls visit(i, sums) for each pair model: sums[c XOR U V^-1 d], times 2^k, is what the
    /// columns add to the sum of its products. `relative` is V U^-1 for t < 2^k. Any thread.
    template <typename Visit>
    void forEachModel(const Order& relative, Visit visit) const {
        const auto second = transforms(relative, &Product::second);
        std::vector<float> sums(relative.size());
        for (std::size_t i = 0; i < pairModels().size(); ++i) {
            addTerms(pairModels()[i], second, sums);
            visit(i, sums);
        }
    }

private:
    using Transforms = std::vector<std::vector<float>>; ///< by number of level function

    static Transforms transforms(const Order& order, std::size_t Product::*side);
    void addTerms(const PairModel& model, const Transforms& second, std::vector<float>& sums) const;

    Transforms first_;
};

} // namespace wellstrat::bank
