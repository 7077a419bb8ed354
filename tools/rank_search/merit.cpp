// SPDX-License-Identifier: Apache-2.0
#include "rank_search/merit.h"

#include "bank_search/spectra.h"

#include <cmath>
#include <numeric>

namespace wellstrat::ranks {
namespace {

enum Function : std::size_t { kSmooth, kEdge, kBox, kSmoothX, kStepX, kSmoothZ, kStepZ, kAcross };

std::vector<Products> makeFunctions() {
    std::vector<Products> result{productsXY(bank::smooth), productsXY(bank::edge),
                                 productsXY(bank::box),    productsX(bank::smooth1D),
                                 productsX(bank::step1D),  productsZ(bank::smooth1D),
                                 productsZ(bank::step1D)};
    for (const bank::SpectrumTerm& term : bank::edgeTerms()) result.push_back(productsX(term.of));
    return result;
}

/// The mean over n in [2^(k-1), 2^k), or at n = 0, in one pixel.
double levelMean(const Products& function, unsigned k) {
    if (k == 0) return function[0];
    double sum = 0;
    for (std::size_t n = std::size_t{1} << (k - 1); n < std::size_t{1} << k; ++n) {
        sum += function[n * kRanks];
    }
    return std::ldexp(sum, 1 - static_cast<int>(k));
}

struct Product {
    double weight;
    std::size_t first, second;
};

/// A kind of functions with a squared mean of 1.
struct Model {
    double weight;
    std::vector<Product> products;
};

Merit meritOf(std::vector<Model> models, bool pairs) {
    double total = 0;
    for (const Model& model : models) total += model.weight * (kRunDigits + 1);
    Merit merit;
    for (const Model& model : models) {
        std::array<double, kRun> weight{};
        double sum = 0; // of the products of padded domains
        for (unsigned k = 0; k <= kRunDigits; ++k) {
            for (const Product& product : model.products) {
                const double first = levelMean(functions()[product.first], k);
                const double second = pairs ? levelMean(functions()[product.second], k) : 1;
                sum += product.weight * first * second *
                       (k == 0 ? 1 : std::ldexp(0.5, static_cast<int>(k)));
            }
            const double variance = std::ldexp(sum, -static_cast<int>(k)) - 1;
            const double share = model.weight / total / variance;
            merit.offset += share;
            for (std::size_t n = 0; n < std::size_t{1} << k; ++n) {
                weight[n] += std::ldexp(share, -static_cast<int>(k));
            }
        }
        for (const Product& product : model.products) {
            Term term{product.first, product.second, weight};
            for (double& w : term.weight) w *= product.weight;
            merit.terms.push_back(term);
        }
    }
    return merit;
}

Merit makeMeritOfOne() {
    return meritOf({{1, {{1, kSmooth, kSmooth}}},
                    {1, {{1, kEdge, kEdge}}},
                    {0.5, {{1, kBox, kBox}}},
                    {0.5, {{1, kSmoothX, kSmoothX}}},
                    {0.5, {{1, kStepX, kStepX}}},
                    {0.25, {{1, kSmoothZ, kSmoothZ}}},
                    {0.25, {{1, kStepZ, kStepZ}}}},
                   false);
}

Merit makeMeritOfPairs() {
    Model across{1, {}};
    const std::vector<bank::SpectrumTerm> terms = bank::edgeTerms();
    for (std::size_t i = 0; i < terms.size(); ++i) {
        across.products.push_back({terms[i].weight, kAcross + i, kAcross + i});
    }
    return meritOf(
        {{1, {{1, kSmooth, kSmooth}}}, {1, {{1, kEdge, kEdge}}}, {0.5, {{1, kBox, kBox}}}, across},
        true);
}

} // namespace

const std::vector<Products>& functions() {
    static const std::vector<Products> all = makeFunctions();
    return all;
}

const Merit& meritOfOne() {
    static const Merit merit = makeMeritOfOne();
    return merit;
}

const Merit& meritOfPairs() {
    static const Merit merit = makeMeritOfPairs();
    return merit;
}

std::vector<Products> functionsIn(const std::vector<uint16_t>& places,
                                  const std::vector<uint16_t>& images) {
    std::vector<Products> result;
    for (const Products& function : functions()) {
        result.push_back(visited(function, places, images));
    }
    return result;
}

Covariance covarianceOfOne(const std::vector<Products>& domain) {
    Covariance covariance(kRanks, -meritOfOne().offset);
    for (const Term& term : meritOfOne().terms) {
        for (std::size_t n = 0; n < kRun; ++n) {
            const double* const f = domain[term.first].data() + n * kRanks;
            for (std::size_t r = 0; r < kRanks; ++r) covariance[r] += term.weight[n] * f[r];
        }
    }
    return covariance;
}

Covariance covarianceOfPair(const std::vector<Products>& first,
                            const std::vector<Products>& second) {
    Covariance covariance(kRanks, -meritOfPairs().offset);
    for (const Term& term : meritOfPairs().terms) {
        for (std::size_t n = 0; n < kRun; ++n) {
            const double* const f = first[term.first].data() + n * kRanks;
            const double* const g = second[term.second].data() + n * kRanks;
            for (std::size_t r = 0; r < kRanks; ++r) covariance[r] += term.weight[n] * f[r] * g[r];
        }
    }
    return covariance;
}

} // namespace wellstrat::ranks
