// SPDX-License-Identifier: Apache-2.0
#include "bank_search/spectra.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wellstrat::bank {
namespace {

double powerOfTwo(int exponent) { return std::ldexp(1.0, exponent); }
int toInt(unsigned k) { return static_cast<int>(k); }

} // namespace

/// 4^-(k+l), halved where both axes take part.
double smooth(unsigned k, unsigned l) {
    if (k == 0 && l == 0) return 1;
    return powerOfTwo(-2 * toInt(k + l) - (k > 0 && l > 0 ? 1 : 0));
}

double edge(unsigned k, unsigned l) {
    return powerOfTwo(toInt(std::min(k, l)) - 2 * toInt(std::max(k, l)));
}

double box(unsigned k, unsigned l) { return powerOfTwo(-toInt(k + l)); }

double step(unsigned k, unsigned l) { return k > 0 && l > 0 ? 0 : box(k, l); }

double smooth1D(unsigned k) { return powerOfTwo(-2 * toInt(k)); }
double step1D(unsigned k) { return powerOfTwo(-toInt(k)); }

std::vector<SpectrumTerm> edgeTerms() {
    constexpr unsigned kTerms = 5;
    double rest[kDigits + 1][kDigits + 1];
    for (unsigned k = 0; k <= kDigits; ++k) {
        for (unsigned l = 0; l <= kDigits; ++l) rest[k][l] = edge(k, l);
    }
    std::vector<SpectrumTerm> terms;
    for (unsigned j = 0; j < kTerms; ++j) {
        const double pivot = rest[j][j];
        std::array<double, kDigits + 1> row{};
        for (unsigned k = j; k <= kDigits; ++k) row[k] = rest[j][k] / pivot;
        for (unsigned k = 0; k <= kDigits; ++k) {
            for (unsigned l = 0; l <= kDigits; ++l) rest[k][l] -= pivot * row[k] * row[l];
        }
        terms.push_back({pivot, [row](unsigned k) { return row[k]; }});
    }
    return terms;
}

} // namespace wellstrat::bank
