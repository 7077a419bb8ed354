// SPDX-License-Identifier: Apache-2.0
//
// What is asked of a bank: for several kinds of functions of two domains, the error with N points,
// N = 8, 16, ..., 4096, as a ratio to that of padding, which orders the domains by independent
// nested shuffles. All of it is exact arithmetic on level functions; no sample is drawn.

#pragma once

#include "bank_search/level_function.h"

#include <array>
#include <string>
#include <vector>

namespace wellstrat::bank {

/// One term of a sum of products of a function of one slot and one of another.
struct Product {
    float weight;
    LevelFunction first, second;
};

/// A kind of functions of two domains. Symmetric in the domains.
struct PairModel {
    std::string name;
    float weight; ///< in the merit
    std::vector<Product> terms;
    float squaredMean;
    /// The variance of the mean of 2^m padded points.
    std::array<float, kDigits + 1> padded;
};

/// A term of a sum of products of functions of three slots.
struct TripleProduct {
    float weight;
    LevelFunction first, second, third;
};

/// A kind of functions of three domains. Symmetric in the first one and each of the others.
struct TripleModel {
    std::string name;
    float weight;
    std::vector<TripleProduct> terms;
    float squaredMean;
    std::array<float, kDigits + 1> padded;
};

const std::vector<PairModel>& pairModels();
const std::vector<TripleModel>& tripleModels();

/// The price of a squared error ratio: the ratio itself, and steeply more above kTolerance.
float price(float squaredRatio);
constexpr float kTolerance = 1.1f;

/// The first N that counts is 2^kFirstDigits: with fewer points all banks are alike.
constexpr unsigned kFirstDigits = 3;

/// The squared error ratio of a pair of slots at 2^m points, for m in [0, kDigits].
std::array<double, kDigits + 1> squaredRatios(const PairModel& model,
                                              const std::vector<uint16_t>& first,
                                              const std::vector<uint16_t>& second);

} // namespace wellstrat::bank
