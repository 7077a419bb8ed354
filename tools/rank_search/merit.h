// SPDX-License-Identifier: Apache-2.0
//
// What is asked of ranks: for several kinds of functions, the squared error of the mean of 2^k
// samples a pixel, k = 0 to kRunDigits, after a filter over the pixels, as a ratio to that of
// independent pixels with padded domains. It is a mean over pairs of pixels of a function of the
// exclusive or of their ranks alone, and so exact arithmetic without a sample:
//
//     merit = sum over rho of weights[rho] * covariance[rho]
//
// The covariance is that of what is drawn, the weights are those of the filter and the tile
// (rank_search/tile.h).

#pragma once

#include "rank_search/products.h"

#include <array>
#include <string>
#include <vector>

namespace wellstrat::ranks {

/// weight * f(domain) g(other domain), where f is functions()[first] and g functions()[second].
struct Product {
    double weight;
    std::size_t first, second;
};

/// A kind of functions of two domains, or of one if g is 1. A sum of products, symmetric in the
/// domains if there are two, with a squared mean of 1.
struct Model {
    std::string name;
    double weight; ///< in the merit
    std::vector<Product> products;
};

const std::vector<Products>& functions();
const std::vector<Model>& modelsOfOne();
const std::vector<Model>& modelsOfPairs();

/// A linear combination of what models ask of all numbers of samples: the sum over all terms and n
/// < kRun of weight[n] f(n) g(n), less an offset.
struct Sums {
    struct Term {
        std::size_t first, second;
        std::array<double, kRun> weight;
    };
    std::vector<Term> terms;
    double offset = 0;
};

Sums sumsOf(const Model& model, unsigned k); ///< with 2^k samples
const Sums& sumsOfOne();                     ///< mean over all models, weighted, and all k
const Sums& sumsOfPairs();

/// By rho = r XOR r', in [0, kRanks): the covariance of the means of pixels of ranks r and r', over
/// the variance of independent ones.
using Covariance = std::vector<double>;

/// Of functions of one domain, `second` does not matter.
Covariance covarianceOf(const Sums& sums, const Visits& first, const Visits& second);

} // namespace wellstrat::ranks
