// SPDX-License-Identifier: Apache-2.0
#include "bank_search/merit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace wellstrat::bank {
namespace {

double powerOfTwo(int exponent) { return std::ldexp(1.0, exponent); }
int toInt(unsigned k) { return static_cast<int>(k); }

// Spectra. All have a mean of 1 beside what varies, or of 0.1 where only certain levels do.

constexpr double kBandMean = 0.1;

/// Differentiable: 4^-(k+l), halved where both axes take part.
double smooth(unsigned k, unsigned l) {
    if (k == 0 && l == 0) return 1;
    return powerOfTwo(-2 * toInt(k + l) - (k > 0 && l > 0 ? 1 : 0));
}

/// An edge at no particular angle.
double edge(unsigned k, unsigned l) {
    return powerOfTwo(toInt(std::min(k, l)) - 2 * toInt(std::max(k, l)));
}

/// A rectangle.
double box(unsigned k, unsigned l) { return powerOfTwo(-toInt(k + l)); }

/// An edge along an axis.
double step(unsigned k, unsigned l) { return k > 0 && l > 0 ? 0 : box(k, l); }

/// Detail of about 2^p periods along one axis and 2^q along the other.
Spectrum2D band(unsigned p, unsigned q) {
    return [p, q](unsigned k, unsigned l) {
        if (k == 0 && l == 0) return kBandMean;
        if (k == 0 || l == 0) return 0.0;
        return powerOfTwo(-2 * (std::abs(toInt(k) - toInt(p)) + std::abs(toInt(l) - toInt(q))));
    };
}

/// The same along one axis only.
Spectrum2D stripes(unsigned p) {
    return [p](unsigned k, unsigned l) {
        if (k == 0 && l == 0) return kBandMean;
        if (k > 0 && l > 0) return 0.0;
        return powerOfTwo(-2 * std::abs(toInt(k + l) - toInt(p)));
    };
}

double smooth1D(unsigned k) { return powerOfTwo(-2 * toInt(k)); }
double step1D(unsigned k) { return powerOfTwo(-toInt(k)); }

/// E[mean^2] of 2^m padded points, for each m: a nested shuffle makes the pair (i, i XOR n) into
/// any pair that parts at the same highest digit.
template <typename Model, typename TermSum>
void setPadded(Model& model, TermSum termSum) {
    std::array<double, kDigits + 1> sum{};
    sum[0] = termSum(0u, 1u);
    for (unsigned m = 0; m < kDigits; ++m) sum[m + 1] = sum[m] + termSum(1u << m, 2u << m);
    for (unsigned m = 0; m <= kDigits; ++m) {
        model.padded[m] = static_cast<float>(std::ldexp(sum[m], -toInt(m)) - model.squaredMean);
    }
}

double mean(const LevelFunction& function, unsigned begin, unsigned end) {
    double sum = 0;
    for (unsigned n = begin; n < end; ++n) sum += double(function[n]);
    return sum / (end - begin);
}

PairModel pairModel(std::string name, float weight, std::vector<Product> terms,
                    double squaredMean) {
    PairModel model{std::move(name), weight, std::move(terms), static_cast<float>(squaredMean), {}};
    setPadded(model, [&](unsigned begin, unsigned end) {
        double sum = 0;
        for (const Product& term : model.terms) {
            sum += double(term.weight) * (end - begin) * mean(term.first, begin, end) *
                   mean(term.second, begin, end);
        }
        return sum;
    });
    return model;
}

/// f(domain) f(other domain).
PairModel square(const std::string& name, float weight, const LevelFunction& f, double mean) {
    return pairModel(name + " x " + name, weight, {{1, f, f}}, mean * mean);
}

/// f(domain) g(other domain), and the other way round.
PairModel product(const std::string& name, float weight, const LevelFunction& f,
                  const LevelFunction& g) {
    return pairModel(name, weight, {{0.5f, f, g}, {0.5f, g, f}}, 1);
}

using FunctionOf = std::function<LevelFunction(const Spectrum1D&)>;

/// A function of one coordinate of a domain and one of another, with an edge at no particular
/// angle. Its spectrum becomes a sum of products by Cholesky's decomposition.
PairModel edgeAcross(const std::string& name, float weight, const FunctionOf& ofFirst,
                     const FunctionOf& ofSecond) {
    constexpr unsigned kTerms = 5; // those left out have less than a thousandth of the variance
    double rest[kDigits + 1][kDigits + 1];
    for (unsigned k = 0; k <= kDigits; ++k) {
        for (unsigned l = 0; l <= kDigits; ++l) rest[k][l] = edge(k, l);
    }
    std::vector<Product> terms;
    for (unsigned j = 0; j < kTerms; ++j) {
        const double pivot = rest[j][j];
        std::array<double, kDigits + 1> row{};
        for (unsigned k = j; k <= kDigits; ++k) row[k] = rest[j][k] / pivot;
        for (unsigned k = 0; k <= kDigits; ++k) {
            for (unsigned l = 0; l <= kDigits; ++l) rest[k][l] -= pivot * row[k] * row[l];
        }
        const Spectrum1D spectrum = [row](unsigned k) { return row[k]; };
        const LevelFunction first = ofFirst(spectrum), second = ofSecond(spectrum);
        const auto half = static_cast<float>(pivot / 2);
        terms.push_back({half, first, second});
        terms.push_back({half, second, first});
    }
    return pairModel(name, weight, std::move(terms), edge(0, 0));
}

std::vector<PairModel> makePairModels() {
    const LevelFunction smoothXY = levelFunction(smooth), edgeXY = levelFunction(edge);
    const LevelFunction stepZ = levelFunctionZ(step1D), smoothZ = levelFunctionZ(smooth1D);
    const FunctionOf ofX = [](const Spectrum1D& spectrum) { return levelFunctionX(spectrum); };
    const FunctionOf ofZ = levelFunctionZ;
    std::vector<PairModel> models{
        square("smooth", 1, smoothXY, 1),
        square("edge", 1.5f, edgeXY, 1),
        square("box", 1, levelFunction(box), 1),
        square("step", 1, levelFunction(step), 1),
        edgeAcross("edge across", 1.5f, ofX, ofX),
        square("step of z", 0.4f, stepZ, 1),
        product("step of z x edge", 0.4f, stepZ, edgeXY),
        product("smooth of z x smooth", 0.3f, smoothZ, smoothXY),
        edgeAcross("edge across z", 0.4f, ofX, ofZ),
    };
    for (const auto& [p, q] :
         {std::pair(1u, 1u), std::pair(1u, 2u), std::pair(2u, 2u), std::pair(1u, 3u),
          std::pair(2u, 3u), std::pair(3u, 3u), std::pair(3u, 4u), std::pair(4u, 4u)}) {
        models.push_back(square("band " + std::to_string(p) + ' ' + std::to_string(q), 0.5f,
                                levelFunction(band(p, q)), kBandMean));
    }
    for (const unsigned p : {1u, 2u, 3u}) {
        models.push_back(
            square("stripes " + std::to_string(p), 0.4f, levelFunction(stripes(p)), kBandMean));
    }
    for (const unsigned split : {1u, 2u, 4u}) {
        const std::string branches = " by " + std::to_string(1u << split);
        // Smooth functions leave so little to 16 branches that single precision would not see it.
        if (split < 4) {
            models.push_back(product("smooth x smooth" + branches, 0.3f, smoothXY,
                                     levelFunction(smooth, split)));
        }
        models.push_back(
            product("edge x edge" + branches, 0.3f, edgeXY, levelFunction(edge, split)));
        const FunctionOf ofSplitX = [split](const Spectrum1D& spectrum) {
            return levelFunctionX(spectrum, split);
        };
        models.push_back(edgeAcross("edge across" + branches, 0.3f, ofX, ofSplitX));
    }
    return models;
}

TripleModel tripleModel(std::string name, float weight, std::vector<TripleProduct> terms) {
    TripleModel model{std::move(name), weight, std::move(terms), 1, {}};
    setPadded(model, [&](unsigned begin, unsigned end) {
        double sum = 0;
        for (const TripleProduct& term : model.terms) {
            sum += double(term.weight) * (end - begin) * mean(term.first, begin, end) *
                   mean(term.second, begin, end) * mean(term.third, begin, end);
        }
        return sum;
    });
    return model;
}

/// A function of z of any of the three slots times one of (x, y) of each of the others.
TripleModel withZ(const std::string& name, float weight, const LevelFunction& z,
                  const LevelFunction& xy) {
    constexpr float kThird = 1.0f / 3;
    return tripleModel(name, weight,
                       {{kThird, z, xy, xy}, {kThird, xy, z, xy}, {kThird, xy, xy, z}});
}

std::vector<TripleModel> makeTripleModels() {
    const LevelFunction smoothXY = levelFunction(smooth), edgeXY = levelFunction(edge);
    return {tripleModel("smooth^3", 0.1f, {{1, smoothXY, smoothXY, smoothXY}}),
            tripleModel("edge^3", 0.1f, {{1, edgeXY, edgeXY, edgeXY}}),
            withZ("step of z x edge^2", 0.1f, levelFunctionZ(step1D), edgeXY)};
}

} // namespace

const std::vector<PairModel>& pairModels() {
    static const std::vector<PairModel> models = makePairModels();
    return models;
}

const std::vector<TripleModel>& tripleModels() {
    static const std::vector<TripleModel> models = makeTripleModels();
    return models;
}

float price(float squaredRatio) {
    const float ratio = std::sqrt(std::max(squaredRatio, 0.0f));
    const float excess = std::max(ratio - kTolerance, 0.0f);
    return ratio + 2 * excess + 10 * excess * excess;
}

std::array<double, kDigits + 1> squaredRatios(const PairModel& model,
                                              const std::vector<uint16_t>& first,
                                              const std::vector<uint16_t>& second) {
    std::array<double, kDigits + 1> ratios{};
    double sum = 0;
    for (unsigned m = 0, n = 0; m <= kDigits; ++m) {
        for (; n < 1u << m; ++n) {
            for (const Product& term : model.terms) {
                sum += double(term.weight * term.first[first[n]] * term.second[second[n]]);
            }
        }
        ratios[m] =
            (std::ldexp(sum, -toInt(m)) - double(model.squaredMean)) / double(model.padded[m]);
    }
    return ratios;
}

} // namespace wellstrat::bank
