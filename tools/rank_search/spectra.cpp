// SPDX-License-Identifier: Apache-2.0
#include "rank_search/spectra.h"

#include <array>

namespace wellstrat::ranks {
namespace {

/// Of differences of level k.
double levelProduct(unsigned k, unsigned digits) {
    if (digits >= k) return 1;
    return digits + 1 == k ? -1 : 0;
}

} // namespace

std::vector<SpectrumTerm> edgeTerms() {
    constexpr unsigned kTerms = 5;
    double rest[kLevels + 1][kLevels + 1];
    for (unsigned k = 0; k <= kLevels; ++k) {
        for (unsigned l = 0; l <= kLevels; ++l) rest[k][l] = edge(k, l);
    }
    std::vector<SpectrumTerm> terms;
    for (unsigned j = 0; j < kTerms; ++j) {
        const double pivot = rest[j][j];
        std::array<double, kLevels + 1> row{};
        for (unsigned k = j; k <= kLevels; ++k) row[k] = rest[j][k] / pivot;
        for (unsigned k = 0; k <= kLevels; ++k) {
            for (unsigned l = 0; l <= kLevels; ++l) rest[k][l] -= pivot * row[k] * row[l];
        }
        terms.push_back({pivot, [row](unsigned k) { return row[k]; }});
    }
    return terms;
}

Products1D::Products1D(const Spectrum1D& spectrum) : of() {
    for (unsigned a = 0; a <= kLevels; ++a) {
        for (unsigned k = 0; k <= kLevels; ++k) of[a] += spectrum(k) * levelProduct(k, a);
    }
}

Products2D::Products2D(const Spectrum2D& spectrum) : of() {
    for (unsigned a = 0; a <= kLevels; ++a) {
        for (unsigned b = 0; b <= kLevels; ++b) {
            for (unsigned k = 0; k <= kLevels; ++k) {
                for (unsigned l = 0; l <= kLevels; ++l) {
                    of[a][b] += spectrum(k, l) * levelProduct(k, a) * levelProduct(l, b);
                }
            }
        }
    }
}

} // namespace wellstrat::ranks
