// SPDX-License-Identifier: Apache-2.0
#include "bank_search/level_function.h"

#include "wellstrat/sobol.h"

#include <algorithm>

namespace wellstrat::bank {
namespace {

/// The expectation of the product of a level-k difference at two points that share `digits` digits.
double levelProduct(unsigned k, unsigned digits) {
    if (digits >= k) return 1;
    return digits + 1 == k ? -1 : 0;
}

unsigned leadingZeros(uint32_t value) {
    unsigned count = 0;
    while (count < kDigits && (value >> (31 - count) & 1u) == 0) ++count;
    return count;
}

unsigned sharedDigits(unsigned dimension, unsigned n) {
    static const SobolMatrix matrices[] = {sobolMatrix(0), sobolMatrix(1), sobolMatrix(2)};
    return leadingZeros(sobolSample(matrices[dimension], n));
}

/// Mean over U and P U.
LevelFunction meanOverSwap(const LevelFunction& function) {
    LevelFunction mean(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) {
        mean[n] = 0.5f * (function[n] + function[pascalTimes(n)]);
    }
    return mean;
}

/// Visit n has the points [n 2^split, (n + 1) 2^split) of tables that end after 4096 points: visits
/// of different tables are independent and share nothing but the mean.
LevelFunction meanOverVisit(const LevelFunction& function, unsigned split, double squaredMean) {
    const unsigned size = 1u << split;
    LevelFunction visits(kPoints, static_cast<float>(squaredMean));
    for (unsigned n = 0; n < kPoints / size; ++n) {
        double sum = 0;
        for (unsigned branch = 0; branch < size; ++branch) {
            sum += double(function[n * size + branch]);
        }
        visits[n] = static_cast<float>(sum / size);
    }
    return visits;
}

LevelFunction plainFunction(const Spectrum2D& spectrum) {
    double byDigits[kDigits + 1][kDigits + 1] = {};
    for (unsigned a = 0; a <= kDigits; ++a) {
        for (unsigned b = 0; b <= kDigits; ++b) {
            for (unsigned k = 0; k <= kDigits; ++k) {
                for (unsigned l = 0; l <= kDigits; ++l) {
                    byDigits[a][b] += spectrum(k, l) * levelProduct(k, a) * levelProduct(l, b);
                }
            }
        }
    }
    LevelFunction function(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) {
        function[n] = static_cast<float>(byDigits[sharedDigitsX(n)][sharedDigitsY(n)]);
    }
    return function;
}

/// Of one coordinate, which is x or z.
LevelFunction plainFunction(const Spectrum1D& spectrum, unsigned (*sharedDigits)(unsigned)) {
    std::array<double, kDigits + 1> byDigits{};
    for (unsigned digits = 0; digits <= kDigits; ++digits) {
        for (unsigned k = 0; k <= kDigits; ++k) {
            byDigits[digits] += spectrum(k) * levelProduct(k, digits);
        }
    }
    LevelFunction function(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) {
        function[n] = static_cast<float>(byDigits[sharedDigits(n)]);
    }
    return function;
}

} // namespace

unsigned sharedDigitsX(unsigned n) { return sharedDigits(0, n); }
unsigned sharedDigitsY(unsigned n) { return sharedDigits(1, n); }
unsigned sharedDigitsZ(unsigned n) { return sharedDigits(2, n); }

LevelFunction levelFunction(const Spectrum2D& spectrum) {
    return meanOverSwap(plainFunction(spectrum));
}

LevelFunction levelFunctionX(const Spectrum1D& spectrum) {
    return meanOverSwap(plainFunction(spectrum, sharedDigitsX));
}

LevelFunction levelFunctionZ(const Spectrum1D& spectrum) {
    return meanOverSwap(plainFunction(spectrum, sharedDigitsZ));
}

LevelFunction levelFunction(const Spectrum2D& spectrum, unsigned split) {
    return meanOverSwap(meanOverVisit(plainFunction(spectrum), split, spectrum(0, 0)));
}

LevelFunction levelFunctionX(const Spectrum1D& spectrum, unsigned split) {
    return meanOverSwap(meanOverVisit(plainFunction(spectrum, sharedDigitsX), split, spectrum(0)));
}

} // namespace wellstrat::bank
