// SPDX-License-Identifier: Apache-2.0
//
// What is asked of ranks: for several kinds of functions, the squared error of the mean of 2^k
// samples a pixel, k = 0 to kRunDigits, after a Gaussian filter over the pixels, as a ratio to that
// of independent pixels. It is a mean over pairs of pixels of a function of the exclusive or of
// their ranks alone, and so exact arithmetic without a sample:
//
//     merit = sum over d of window(d) * mean over pixels p of covariance[r(p) XOR r(p + d)]

#pragma once

#include "rank_search/products.h"

#include <array>
#include <vector>

namespace wellstrat::ranks {

/// By r XOR r', in [0, kRanks): the covariance of the means of two pixels of these ranks over the
/// variance of independent ones, averaged over functions and numbers of samples.
using Covariance = std::vector<double>;

/// What all functions f of one domain and f g of two add up to: the sum over n < kRun of weight[n]
/// f(n), or of weight[n] f(n) g(n), with f and g among `functions`.
struct Term {
    std::size_t first, second; ///< the same for a function of one domain
    std::array<double, kRun> weight;
};

struct Merit {
    std::vector<Term> terms;
    double offset = 0; ///< what squared means add up to
};

/// Products of all functions that terms refer to.
const std::vector<Products>& functions();

const Merit& meritOfOne();   ///< functions of one domain
const Merit& meritOfPairs(); ///< of two slots, symmetric in them

/// The products of all functions in a slot, or in a padded domain: its places and its ranks.
std::vector<Products> functionsIn(const std::vector<uint16_t>& places,
                                  const std::vector<uint16_t>& images);

Covariance covarianceOfOne(const std::vector<Products>& domain);
Covariance covarianceOfPair(const std::vector<Products>& first,
                            const std::vector<Products>& second);

} // namespace wellstrat::ranks
