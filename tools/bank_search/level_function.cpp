// SPDX-License-Identifier: Apache-2.0
#include "bank_search/level_function.h"

#include "wellstrat/sobol.h"

namespace wellstrat::bank {
namespace {

/// Leading digits that two points share whose coordinates differ by `difference`.
unsigned leadingZeros(uint32_t difference) {
    unsigned count = 0;
    while (count < kDigits && (difference >> (31 - count) & 1u) == 0) ++count;
    return count;
}

/// From shares of levels to what they add up to at two points that share so many digits: a level k
/// counts in full with k digits or more, negative with k - 1, and not at all with less.
void sumAlongAxis(double* first, std::size_t stride) {
    double sum = 0;
    for (unsigned digits = 0; digits <= kDigits; ++digits) {
        double& value = first[digits * stride];
        sum += value;
        value = sum - (digits < kDigits ? first[(digits + 1) * stride] : 0);
    }
}

/// E[f(p) f(q)] less the squared mean, by the digits that p and q share.
ByLevels sumOverLevels(ByLevels shares) {
    constexpr std::size_t kSize = kDigits + 1;
    shares[0][0][0] = 0;
    for (unsigned a = 0; a < kSize; ++a) {
        for (unsigned b = 0; b < kSize; ++b) {
            sumAlongAxis(&shares[a][b][0], 1);
        }
    }
    for (unsigned a = 0; a < kSize; ++a) {
        for (unsigned b = 0; b < kSize; ++b) {
            sumAlongAxis(&shares[a][0][b], kSize);
        }
    }
    for (unsigned a = 0; a < kSize; ++a) {
        for (unsigned b = 0; b < kSize; ++b) {
            sumAlongAxis(&shares[0][a][b], kSize * kSize);
        }
    }
    return shares;
}

/// For points of index i, i XOR n; the mean over the 2^split samples of visits, if n is of those.
std::vector<double> inOwnOrder(const ByLevels& shares, unsigned split) {
    static const SobolMatrix matrices[] = {sobolMatrix(0), sobolMatrix(1), sobolMatrix(2)};
    const ByLevels sums = sumOverLevels(shares);
    const unsigned size = 1u << split;
    std::vector<double> result(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) {
        for (unsigned index = n * size; index < (n + 1) * size; ++index) {
            const unsigned x = leadingZeros(sobolSample(matrices[0], index));
            const unsigned y = leadingZeros(sobolSample(matrices[1], index));
            const unsigned z = leadingZeros(sobolSample(matrices[2], index));
            result[n] += sums[z][y][x] / size;
        }
    }
    return result;
}

std::vector<double> meanOverSwap(const std::vector<double>& values) {
    std::vector<double> mean(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) mean[n] = (values[n] + values[pascalTimes(n)]) / 2;
    return mean;
}

} // namespace

ByLevels sharesOf(const Spectrum& spectrum) {
    ByLevels shares{};
    for (unsigned j = 0; j <= kDigits; ++j) {
        for (unsigned l = 0; l <= kDigits; ++l) {
            for (unsigned k = 0; k <= kDigits; ++k) shares[j][l][k] = spectrum(k, l, j);
        }
    }
    return shares;
}

std::vector<double> covariances(const ByLevels& shares) {
    return meanOverSwap(inOwnOrder(shares, 0));
}

LevelFunction levelFunction(const ByLevels& shares) { return levelFunction(shares, 0); }

LevelFunction levelFunction(const ByLevels& shares, unsigned split) {
    const std::vector<double> values = meanOverSwap(inOwnOrder(shares, split));
    return {shares[0][0][0], {values.begin(), values.end()}, prefixSums(values)};
}

} // namespace wellstrat::bank
