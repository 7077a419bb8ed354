// SPDX-License-Identifier: Apache-2.0
//
// What is asked of a bank: for several kinds of functions of two and three domains, the error with
// N points, N = 8, 16, ..., 65536, as a ratio to that of padding, which orders the domains by
// independent nested shuffles. All of it is exact arithmetic on level functions; no sample is
// drawn.

#pragma once

#include "bank_search/level_function.h"

#include <string>
#include <vector>

namespace wellstrat::bank {

/// The first N that counts is 2^kFirstDigits: with fewer points all banks are alike.
constexpr unsigned kFirstDigits = 3;

/// All level functions that models are made of; models have their numbers.
const std::vector<LevelFunction>& levelFunctions();

/// What is asked of slots.
struct Standard {
    float weight;    ///< of the price
    float tolerance; ///< ratios above are expensive
    float limit;   ///< of products of the lab's integrands; ratios above are out of the question...
    float penalty; ///< ...but for this price, times the square of the excess
};

/// A term of a sum of products of a function of one slot and one of another.
struct Product {
    double weight;
    std::size_t first, second;
};

/// A kind of functions of two domains, of which the first is drawn from one slot and the second
/// from another. Those that are not symmetric have a model for either direction.
struct PairModel {
    std::string name;
    float weight; ///< of the price; 0 of a product of integrands, which has a limit instead
    std::vector<Product> terms;
    /// 2^m times the variance of the mean of 2^m points, but for the sums of the products of what
    /// varies, which depend on the bank.
    ByDigits apart;
    ByDigits padded; ///< the same with the sums that padding has
};

/// A term of a sum of products of functions of three slots.
struct TripleProduct {
    double weight;
    std::size_t first, second, third;
};

/// A kind of functions of three domains. Symmetric in the first one and each of the others.
struct TripleModel {
    std::string name;
    float weight; ///< of the price
    std::vector<TripleProduct> terms;
    double squaredMean;
    ByDigits padded; ///< 2^m times the variance
};

const std::vector<PairModel>& pairModels();
const std::vector<TripleModel>& tripleModels();

/// The price of a squared error ratio: the ratio, and steeply more above what is tolerated.
float price(float squaredRatio, const Standard& standard);

/// The price of the squared error ratio of a pair with 2^digits points. Products of integrands cost
/// nothing but above their limit, from 64 points on.
float price(const PairModel& model, unsigned digits, float squaredRatio, const Standard& standard);

/// What pairs and triples whose largest number is `slot` are held to: pairs of lower slots to more,
/// and slots 0 and 1, which most programs take, to most.
Standard standardOf(std::size_t slot);

/// The weight of the price for 2^digits points: with few points little can be had, and much be
/// spoilt for more.
constexpr float weightOfDigits(unsigned digits) {
    return digits < kFirstDigits ? 0.0f : digits < 6 ? 0.3f : 1.0f;
}

/// The squared error ratio of a pair of slots at 2^m points, for m in [0, kDigits], as far as their
/// orders reach.
ByDigits squaredRatios(const PairModel& model, const std::vector<uint16_t>& first,
                       const std::vector<uint16_t>& second);

} // namespace wellstrat::bank
