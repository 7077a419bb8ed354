// SPDX-License-Identifier: Apache-2.0
#include "bank_search/merit.h"

#include "bank_search/integrand_levels.h"
#include "bank_search/spectra.h"
#include "wellstrat/analysis/integrands.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wellstrat::bank {
namespace {

/// Collects level functions and the models that are made of them.
class Models {
public:
    std::size_t add(const ByLevels& shares, unsigned split = 0) {
        functions.push_back(levelFunction(shares, split));
        return functions.size() - 1;
    }
    std::size_t add(const Spectrum& spectrum, unsigned split = 0) {
        return add(sharesOf(spectrum), split);
    }

    void addPair(std::string name, float weight, std::vector<Product> terms) {
        PairModel model{std::move(name), weight, std::move(terms), {}, {}};
        for (const Product& term : model.terms) {
            const LevelFunction &f = functions[term.first], &g = functions[term.second];
            double products = 0;
            for (unsigned m = 0; m <= kDigits; ++m) {
                model.apart[m] +=
                    term.weight * (g.squaredMean * f.sums[m] + f.squaredMean * g.sums[m]);
                products += paddedProducts(f, m) * paddedProducts(g, m) / sizeOfRange(m);
                model.padded[m] += term.weight * products;
            }
        }
        for (unsigned m = 0; m <= kDigits; ++m) model.padded[m] += model.apart[m];
        pairs.push_back(std::move(model));
    }

    /// f(domain) f(other domain).
    void addSquare(const std::string& name, float weight, std::size_t f) {
        addPair(name + "^2", weight, {{1, f, f}});
    }

    /// Both directions of a kind of functions that is not symmetric.
    void addBoth(const std::string& name, float weight, const std::vector<Product>& terms) {
        std::vector<Product> exchanged = terms;
        for (Product& term : exchanged) std::swap(term.first, term.second);
        addPair(name, weight, terms);
        addPair(name + ", exchanged", weight, std::move(exchanged));
    }

    void addTriple(std::string name, float weight, std::vector<TripleProduct> terms) {
        TripleModel model{std::move(name), weight, std::move(terms), 0, {}};
        for (const TripleProduct& term : model.terms) {
            const LevelFunction &f = functions[term.first], &g = functions[term.second],
                                &h = functions[term.third];
            const double mean = f.squaredMean * g.squaredMean * h.squaredMean;
            model.squaredMean += term.weight * mean;
            double products = 0;
            for (unsigned m = 0; m <= kDigits; ++m) {
                products += paddedMean(f, m) * paddedMean(g, m) * paddedMean(h, m) * sizeOfRange(m);
                model.padded[m] += term.weight * (products - std::ldexp(mean, toInt(m)));
            }
        }
        triples.push_back(std::move(model));
    }

    std::vector<LevelFunction> functions;
    std::vector<PairModel> pairs;
    std::vector<TripleModel> triples;

private:
    // A nested shuffle makes the pair (i, i XOR n) into any pair that parts at the same highest
    // digit: those of a range [2^(m-1), 2^m), or of 0 alone.
    static double sizeOfRange(unsigned m) { return m == 0 ? 1 : powerOfTwo(toInt(m) - 1); }
    static double paddedProducts(const LevelFunction& f, unsigned m) {
        return m == 0 ? f.sums[0] : f.sums[m] - f.sums[m - 1];
    }
    static double paddedMean(const LevelFunction& f, unsigned m) {
        return f.squaredMean + paddedProducts(f, m) / sizeOfRange(m);
    }
};

/// An edge at no particular angle across one coordinate of a domain and one of another: its
/// spectrum as a sum of products, by Cholesky's decomposition.
struct EdgeTerms {
    static constexpr unsigned kCount = 5; // the rest has less than a thousandth of the variance
    double weights[kCount];
    double factors[kCount][kDigits + 1]; ///< by level
};

EdgeTerms decomposedEdge() {
    EdgeTerms terms{};
    double rest[kDigits + 1][kDigits + 1];
    for (unsigned k = 0; k <= kDigits; ++k) {
        for (unsigned l = 0; l <= kDigits; ++l) rest[k][l] = edge(k, l);
    }
    for (unsigned j = 0; j < EdgeTerms::kCount; ++j) {
        const double pivot = terms.weights[j] = rest[j][j];
        double* const row = terms.factors[j];
        for (unsigned k = j; k <= kDigits; ++k) row[k] = rest[j][k] / pivot;
        for (unsigned k = 0; k <= kDigits; ++k) {
            for (unsigned l = 0; l <= kDigits; ++l) rest[k][l] -= pivot * row[k] * row[l];
        }
    }
    return terms;
}

using EdgeFunctions = std::array<std::size_t, EdgeTerms::kCount>;

/// The factors of one coordinate, which ofX or ofZ chooses.
template <typename OfAxis>
EdgeFunctions addEdgeFunctions(Models& models, const EdgeTerms& edge, OfAxis ofAxis,
                               unsigned split = 0) {
    EdgeFunctions functions{};
    for (unsigned j = 0; j < EdgeTerms::kCount; ++j) {
        const double* const factor = edge.factors[j];
        functions[j] = models.add(ofAxis([factor](unsigned k) { return factor[k]; }), split);
    }
    return functions;
}

std::vector<Product> across(const EdgeTerms& edge, const EdgeFunctions& first,
                            const EdgeFunctions& second) {
    std::vector<Product> terms;
    for (unsigned j = 0; j < EdgeTerms::kCount; ++j) {
        terms.push_back({edge.weights[j], first[j], second[j]});
    }
    return terms;
}

struct Weighted {
    float weight;
    std::string name;
    std::size_t function;
};

/// Without the last bits, in which exp and cos of machines differ.
ByLevels rounded(ByLevels shares) {
    for (auto& plane : shares) {
        for (auto& line : plane) {
            for (double& share : line) share = std::nearbyint(share * 0x1p40) * 0x1p-40;
        }
    }
    return shares;
}

/// All products of two of the lab's integrands, of which a bank is asked that none is bad. These
/// are the ones that bad pairs are bad for.
void addIntegrands(Models& models) {
    constexpr unsigned kGridDigits = 20;
    std::vector<std::pair<std::string, std::size_t>> integrands;
    for (const char* const name :
         {"step-1d", "linear", "gaussian-1d", "smooth-1d", "disk", "step", "gaussian", "smooth",
          "edge-0", "edge-15", "edge-45", "triangle-3d", "edge-3d", "smooth-3d"}) {
        const ByLevels shares = levelShares(makeIntegrand(name), kGridDigits);
        integrands.emplace_back(name, models.add(rounded(shares)));
    }
    for (const auto& [f, first] : integrands) {
        for (const auto& [g, second] : integrands) {
            models.addPair(f + " * " + g, 0, {{1, first, second}});
        }
    }
}

Models makeModels() {
    constexpr float kAlike = 1.5f, kUnlike = 0.3f; // products of functions of two draws
    constexpr std::size_t kOfXY = 4; // the first draws below, whose squares matter most
    constexpr float kEdgeAcross = 2, kEdgeAcrossZ = 0.3f, kBands = 1.1f, kStripes = 2,
                    kSplits = 0.6f, kTriples = 0.2f;
    Models models;
    const std::size_t smoothXY = models.add(ofXY(smooth)), edgeXY = models.add(ofXY(edge));
    const std::vector<Weighted> draws{
        {1, "smooth", smoothXY},
        {1.2f, "edge", edgeXY},
        {0.9f, "box", models.add(ofXY(box))},
        {0.9f, "step", models.add(ofXY(step))},
        {0.7f, "smooth of z", models.add(ofZ(smooth1D))},
        {0.8f, "step of z", models.add(ofZ(step1D))},
        {0.5f, "band of z",
         models.add(ofZ([](unsigned k) { return k == 0 ? 0.25 : band1D(k, 2); }))},
        {0.5f, "band", models.add(ofXY([](unsigned k, unsigned l) {
             return k + l == 0 ? 0.25 : k == 0 || l == 0 ? 0.0 : band1D(k, 1) * band1D(l, 1);
         }))},
        {0.6f, "smooth of xyz", models.add(smooth3D)},
        {0.6f, "edge of xyz", models.add(edge3D)},
        {0.6f, "edge of two axes", models.add(edgeOfTwoAxes)},
    };
    for (std::size_t a = 0; a < draws.size(); ++a) {
        const auto& [weight, name, function] = draws[a];
        models.addSquare(name, (a < kOfXY ? kAlike : 1) * weight * weight, function);
        for (std::size_t b = 0; b < a; ++b) {
            models.addBoth(name + " x " + draws[b].name, kUnlike * weight * draws[b].weight,
                           {{1, function, draws[b].function}});
        }
    }
    const EdgeTerms terms = decomposedEdge();
    const auto alongX = [](const auto& of) { return ofX(of); };
    const auto alongZ = [](const auto& of) { return ofZ(of); };
    const EdgeFunctions x = addEdgeFunctions(models, terms, alongX);
    const EdgeFunctions z = addEdgeFunctions(models, terms, alongZ);
    models.addPair("edge across", kEdgeAcross, across(terms, x, x));
    models.addBoth("edge across, of z", kEdgeAcrossZ, across(terms, x, z));
    models.addPair("edge across, of z and z", kEdgeAcrossZ, across(terms, z, z));
    for (const auto& [p, q] :
         {std::pair(1u, 1u), std::pair(1u, 2u), std::pair(2u, 2u), std::pair(1u, 3u),
          std::pair(2u, 3u), std::pair(3u, 3u), std::pair(3u, 4u), std::pair(4u, 4u)}) {
        models.addSquare("band " + std::to_string(p) + ' ' + std::to_string(q), kBands,
                         models.add(band(p, q)));
    }
    for (const unsigned p : {1u, 2u, 3u}) {
        models.addSquare("stripes " + std::to_string(p), kStripes, models.add(stripes(p)));
    }
    for (const unsigned split : {1u, 2u, 4u}) {
        const std::string branches = " by " + std::to_string(1u << split);
        models.addBoth("smooth x smooth" + branches, kSplits,
                       {{1, smoothXY, models.add(ofXY(smooth), split)}});
        models.addBoth("edge x edge" + branches, kSplits,
                       {{1, edgeXY, models.add(ofXY(edge), split)}});
        models.addBoth("edge across" + branches, kSplits,
                       across(terms, x, addEdgeFunctions(models, terms, alongX, split)));
    }
    addIntegrands(models);
    const std::size_t stepZ = draws[5].function;
    constexpr double kThird = 1.0 / 3;
    models.addTriple("smooth^3", kTriples, {{1, smoothXY, smoothXY, smoothXY}});
    models.addTriple("edge^3", kTriples, {{1, edgeXY, edgeXY, edgeXY}});
    models.addTriple("step of z x edge^2", kTriples,
                     {{kThird, stepZ, edgeXY, edgeXY},
                      {kThird, edgeXY, stepZ, edgeXY},
                      {kThird, edgeXY, edgeXY, stepZ}});
    return models;
}

const Models& models() {
    static const Models all = makeModels();
    return all;
}

} // namespace

const std::vector<LevelFunction>& levelFunctions() { return models().functions; }
const std::vector<PairModel>& pairModels() { return models().pairs; }
const std::vector<TripleModel>& tripleModels() { return models().triples; }

Standard standardOf(std::size_t slot) {
    if (slot < 2) return {8, 1.0f, 1.0f, 3000};
    if (slot < 4) return {4, 1.0f, 1.06f, 3000};
    if (slot < 8) return {2, 1.1f, 1.25f, 1000};
    return {1, 1.35f, 1.65f, 60};
}

float price(float squaredRatio, const Standard& standard) {
    const float ratio = std::sqrt(std::max(squaredRatio, 0.0f));
    const float excess = std::max(ratio - standard.tolerance, 0.0f);
    return standard.weight * (ratio + 2 * excess + 10 * excess * excess);
}

float price(const PairModel& model, unsigned digits, float squaredRatio, const Standard& standard) {
    if (model.weight > 0) return model.weight * price(squaredRatio, standard);
    if (digits < 6) return 0;
    const float excess = std::sqrt(std::max(squaredRatio, 0.0f)) - standard.limit;
    return excess > 0 ? standard.penalty * excess * excess : 0;
}

ByDigits squaredRatios(const PairModel& model, const std::vector<uint16_t>& first,
                       const std::vector<uint16_t>& second) {
    ByDigits ratios = model.apart;
    for (const Product& term : model.terms) {
        const std::vector<float>& f = levelFunctions()[term.first].varying;
        const std::vector<float>& g = levelFunctions()[term.second].varying;
        double sum = 0;
        for (unsigned m = 0, n = 0; m <= kDigits; ++m) {
            for (; n < 1u << m && n < first.size(); ++n)
                sum += double(f[first[n]]) * double(g[second[n]]);
            ratios[m] += term.weight * sum;
        }
    }
    for (unsigned m = 0; m <= kDigits; ++m) ratios[m] /= model.padded[m];
    return ratios;
}

} // namespace wellstrat::bank
