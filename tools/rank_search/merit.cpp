// SPDX-License-Identifier: Apache-2.0
#include "rank_search/merit.h"

namespace wellstrat::ranks {
namespace {

enum Function : std::size_t {
    kOne,
    kSmooth,
    kEdge,
    kBox,
    kSmoothX,
    kStepX,
    kSmoothZ,
    kStepZ,
    kEdgeXZ,
    kSmoothXYZ,
    kAcross ///< and those behind it
};

std::vector<Products> makeFunctions() {
    std::vector<Products> result{Products(std::size_t{kRun} * kRanks, 1.0),
                                 productsXY(smooth),
                                 productsXY(edge),
                                 productsXY(box),
                                 productsX(smooth1D),
                                 productsX(step1D),
                                 productsZ(smooth1D, rankMatrix(2)),
                                 productsZ(step1D, rankMatrix(2)),
                                 productsXZ(edge, rankMatrix(2)),
                                 productsXYZ(smooth, smooth1D, rankMatrix(2))};
    for (const SpectrumTerm& term : edgeTerms()) result.push_back(productsX(term.of));
    return result;
}

std::vector<Model> makeModelsOfPairs() {
    Model across{"edge across", 1, {}};
    std::size_t function = kAcross;
    for (const SpectrumTerm& term : edgeTerms()) {
        across.products.push_back({term.weight, function, function});
        ++function;
    }
    return {{"smooth x smooth", 1, {{1, kSmooth, kSmooth}}},
            {"edge x edge", 1, {{1, kEdge, kEdge}}},
            {"box x box", 0.5, {{1, kBox, kBox}}},
            across};
}

/// The sum over n in [2^(k-1), 2^k), or at n = 0, of the products of padded domains of one pixel: a
/// nested shuffle makes an n any other with the same highest bit.
double paddedSum(const Model& model, unsigned k) {
    const std::size_t begin = k == 0 ? 0 : std::size_t{1} << (k - 1), end = std::size_t{1} << k;
    const auto mean = [&](std::size_t function) {
        double sum = 0;
        for (std::size_t n = begin; n < end; ++n) sum += functions()[function][n * kRanks];
        return sum / static_cast<double>(end - begin);
    };
    double sum = 0;
    for (const Product& product : model.products) {
        sum += product.weight * mean(product.first) * mean(product.second);
    }
    return sum * static_cast<double>(end - begin);
}

void add(const Sums& sums, double weight, Sums* total) {
    total->offset += weight * sums.offset;
    for (const Sums::Term& term : sums.terms) {
        total->terms.push_back(term);
        for (double& w : total->terms.back().weight) w *= weight;
    }
}

/// The mean over all numbers of samples.
Sums meanOverRuns(const Model& model) {
    Sums mean = sumsOf(model, 0);
    for (unsigned k = 1; k <= kRunDigits; ++k) {
        const Sums sums = sumsOf(model, k);
        mean.offset += sums.offset;
        for (std::size_t i = 0; i < mean.terms.size(); ++i) {
            for (std::size_t n = 0; n < kRun; ++n) {
                mean.terms[i].weight[n] += sums.terms[i].weight[n];
            }
        }
    }
    Sums result;
    add(mean, 1.0 / (kRunDigits + 1), &result);
    return result;
}

Sums meanOverModels(const std::vector<Model>& models) {
    double total = 0;
    for (const Model& model : models) total += model.weight;
    Sums result;
    for (const Model& model : models) add(meanOverRuns(model), model.weight / total, &result);
    return result;
}

} // namespace

const std::vector<Products>& functions() {
    static const std::vector<Products> all = makeFunctions();
    return all;
}

const std::vector<Model>& modelsOfOne() {
    static const std::vector<Model> models{
        {"smooth", 1, {{1, kSmooth, kOne}}},
        {"edge", 1, {{1, kEdge, kOne}}},
        {"box", 0.5, {{1, kBox, kOne}}},
        {"smooth of x", 0.5, {{1, kSmoothX, kOne}}},
        {"step of x", 0.5, {{1, kStepX, kOne}}},
        {"smooth of z", 0.5, {{1, kSmoothZ, kOne}}},
        {"step of z", 0.5, {{1, kStepZ, kOne}}},
        {"edge of x, z", 0.5, {{1, kEdgeXZ, kOne}}},
        {"smooth of xyz", 0.5, {{1, kSmoothXYZ, kOne}}},
    };
    return models;
}

const std::vector<Model>& modelsOfPairs() {
    static const std::vector<Model> models = makeModelsOfPairs();
    return models;
}

Sums sumsOf(const Model& model, unsigned k) {
    double padded = 0;
    for (unsigned j = 0; j <= k; ++j) padded += paddedSum(model, j);
    const double variance = padded / levels::powerOfTwo(levels::toInt(k)) - 1;
    Sums sums;
    sums.offset = 1 / variance;
    for (const Product& product : model.products) {
        Sums::Term term{product.first, product.second, {}};
        for (std::size_t n = 0; n < std::size_t{1} << k; ++n) {
            term.weight[n] = product.weight / (levels::powerOfTwo(levels::toInt(k)) * variance);
        }
        sums.terms.push_back(term);
    }
    return sums;
}

const Sums& sumsOfOne() {
    static const Sums sums = meanOverModels(modelsOfOne());
    return sums;
}

const Sums& sumsOfPairs() {
    static const Sums sums = meanOverModels(modelsOfPairs());
    return sums;
}

Covariance covarianceOf(const Sums& sums, const Visits& first, const Visits& second) {
    Covariance covariance(kRanks, -sums.offset);
    for (const Sums::Term& term : sums.terms) {
        for (std::size_t n = 0; n < kRun; ++n) {
            if (term.weight[n] == 0) continue;
            const double* const f = rowOf(functions()[term.first], first, n);
            const double* const g = rowOf(functions()[term.second], second, n);
            for (std::size_t r = 0; r < kRanks; ++r) {
                covariance[r] += term.weight[n] * f[first.images[r]] * g[second.images[r]];
            }
        }
    }
    return covariance;
}

} // namespace wellstrat::ranks
