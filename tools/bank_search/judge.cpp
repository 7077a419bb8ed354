// SPDX-License-Identifier: Apache-2.0
#include "bank_search/judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wellstrat::bank {
namespace {

/// The variance of the mean of f g over 2^m points, from the sums of the covariances of f, of g and
/// of the products of both.
double variance(unsigned m, double squaredMeanF, double squaredMeanG, double sumF, double sumG,
                double sumOfProducts) {
    const double sum = squaredMeanG * sumF + squaredMeanF * sumG + sumOfProducts;
    return std::max(0.0, std::ldexp(sum, -static_cast<int>(m)));
}

constexpr unsigned kBlock = 256;

/// The covariances of all integrands for the indices that a slot visits in a block.
std::vector<double> visited(const std::vector<JudgedIntegrand>& integrands, const uint16_t* order,
                            unsigned count) {
    std::vector<double> values(count * integrands.size());
    for (std::size_t f = 0; f < integrands.size(); ++f) {
        for (unsigned n = 0; n < count; ++n) {
            values[n * integrands.size() + f] = integrands[f].covariance[order[n]];
        }
    }
    return values;
}

} // namespace

Judge::Judge(std::vector<JudgedIntegrand> integrands, unsigned digits)
    : integrands_(std::move(integrands)), digits_(digits) {
    for (const JudgedIntegrand& f : integrands_) {
        alone_.push_back(prefixSums(f.covariance));
    }
    for (std::size_t f = 0; f < integrands_.size(); ++f) {
        for (std::size_t g = 0; g < integrands_.size(); ++g) {
            ByDigits variances{};
            // A nested shuffle makes n into any number with the same highest bit.
            double products = alone_[f][0] * alone_[g][0];
            for (unsigned m = 0; m <= kDigits; ++m) {
                if (m > 0) {
                    products += std::ldexp((alone_[f][m] - alone_[f][m - 1]) *
                                               (alone_[g][m] - alone_[g][m - 1]),
                                           1 - static_cast<int>(m));
                }
                variances[m] = variance(m, integrands_[f].squaredMean, integrands_[g].squaredMean,
                                        alone_[f][m], alone_[g][m], products);
            }
            padded_.push_back(variances);
        }
    }
}

std::vector<ByDigits> Judge::ratios(const Columns& one, const Columns& other) const {
    const std::vector<uint16_t> firstOrder = orderOf(one, digits_);
    const std::vector<uint16_t> secondOrder = orderOf(other, digits_);
    const std::size_t count = integrands_.size();
    std::vector<double> products(count * count);
    std::vector<ByDigits> ratios(count * count);
    for (unsigned m = 0, n = 0; m <= digits_; ++m) {
        while (n < 1u << m) {
            const unsigned size = std::min(kBlock, (1u << m) - n);
            const std::vector<double> first = visited(integrands_, &firstOrder[n], size);
            const std::vector<double> second = visited(integrands_, &secondOrder[n], size);
            for (unsigned i = 0; i < size; ++i) {
                for (std::size_t f = 0; f < count; ++f) {
                    const double factor = first[i * count + f];
                    const double* const values = &second[i * count];
                    double* const row = &products[f * count];
                    for (std::size_t g = 0; g < count; ++g) row[g] += factor * values[g];
                }
            }
            n += size;
        }
        for (std::size_t f = 0; f < count; ++f) {
            for (std::size_t g = 0; g < count; ++g) {
                const std::size_t i = f * count + g;
                const double joint =
                    variance(m, integrands_[f].squaredMean, integrands_[g].squaredMean,
                             alone_[f][m], alone_[g][m], products[i]);
                ratios[i][m] = std::sqrt(joint / padded_[i][m]);
            }
        }
    }
    return ratios;
}

ByDigits Judge::floor(std::size_t f, std::size_t slots) const {
    const JudgedIntegrand& integrand = integrands_[f];
    std::vector<double> squares = integrand.covariance;
    for (double& value : squares) value *= value;
    const ByDigits sums = prefixSums(squares);
    ByDigits result{};
    for (unsigned m = 0; m <= kDigits; ++m) {
        const double alike = variance(m, integrand.squaredMean, integrand.squaredMean, alone_[f][m],
                                      alone_[f][m], sums[m]);
        const double ratio = alike / padded_[f * integrands_.size() + f][m];
        const double squared = 1 - (ratio - 1) / static_cast<double>(slots - 1);
        result[m] = std::sqrt(std::max(0.0, squared));
    }
    return result;
}

} // namespace wellstrat::bank
