// SPDX-License-Identifier: Apache-2.0
#include "bank_search/judge.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace wellstrat::bank {
namespace {

/// A(k, l): the mean square of the integrand's means over dyadic rectangles of 2^-k x 2^-l.
class DyadicMeans {
public:
    explicit DyadicMeans(const Integrand& integrand) : integrand_(integrand) {
        const std::vector<double> columns = rowMeans(0, 0);
        mean_ = std::accumulate(columns.begin(), columns.end(), 0.0) / kPoints;
    }

    double mean() const { return mean_; }

    /// E[f(p) f(q)] for random p and q that share just a digits of x and b of y.
    double product(unsigned a, unsigned b) const {
        if (a == kDigits) return squares_[kDigits][kDigits];
        return 4 * squares_[a][b] - 2 * squares_[a + 1][b] - 2 * squares_[a][b + 1] +
               squares_[a + 1][b + 1];
    }

private:
    /// The means over the rectangles of 2^-12 x 2^-l in one row. Adds up their squares, and those
    /// of wider rectangles, for this row and all that it contains.
    std::vector<double> rowMeans(unsigned l, unsigned row) {
        std::vector<double> means(kPoints);
        if (l == kDigits) {
            for (unsigned x = 0; x < kPoints; ++x) {
                const double point[] = {(x + 0.5) / kPoints, (row + 0.5) / kPoints};
                means[x] = integrand_.value(point);
            }
        } else {
            means = rowMeans(l + 1, 2 * row);
            const std::vector<double> next = rowMeans(l + 1, 2 * row + 1);
            for (unsigned x = 0; x < kPoints; ++x) means[x] = (means[x] + next[x]) / 2;
        }
        addSquares(l, means);
        return means;
    }

    void addSquares(unsigned l, std::vector<double> means) {
        for (unsigned k = kDigits;; --k) {
            double sum = 0;
            for (const double mean : means) sum += mean * mean;
            squares_[k][l] += std::ldexp(sum, -static_cast<int>(k + l));
            if (k == 0) return;
            for (std::size_t i = 0; i < means.size() / 2; ++i) {
                means[i] = (means[2 * i] + means[2 * i + 1]) / 2;
            }
            means.resize(means.size() / 2);
        }
    }

    const Integrand& integrand_;
    double mean_ = 0;
    double squares_[kDigits + 1][kDigits + 1] = {};
};

/// 2^-m times the running sums at n = 2^m, less `squaredMean`.
template <typename Value>
ByDigits variances(double squaredMean, Value value) {
    ByDigits result{};
    double sum = 0;
    for (unsigned m = 0, n = 0; m <= kDigits; ++m) {
        for (; n < 1u << m; ++n) sum += value(n);
        result[m] = std::max(0.0, std::ldexp(sum, -static_cast<int>(m)) - squaredMean);
    }
    return result;
}

/// The means of `function` over the n that have the same highest bit.
std::vector<double> paddedFunction(const std::vector<double>& function) {
    std::vector<double> padded = function;
    for (unsigned begin = 1; begin < kPoints; begin *= 2) {
        double sum = 0;
        for (unsigned n = begin; n < 2 * begin; ++n) sum += function[n];
        std::fill_n(padded.begin() + begin, begin, sum / begin);
    }
    return padded;
}

} // namespace

Judgement judge(const Bank& bank, const Integrand& integrand) {
    if (integrand.domains != DomainDims{2}) {
        throw std::invalid_argument("'" + integrand.name + "' does not have one domain of 2D");
    }
    const DyadicMeans means(integrand);
    std::vector<double> function(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) {
        const unsigned x = sharedDigitsX(n), y = sharedDigitsY(n);
        function[n] = (means.product(x, y) + means.product(y, x)) / 2; // by the random swap
    }
    const double squaredMean = std::pow(means.mean(), 4);
    const std::vector<double> paddedOne = paddedFunction(function);
    const ByDigits padded =
        variances(squaredMean, [&](unsigned n) { return paddedOne[n] * paddedOne[n]; });
    const ByDigits alike =
        variances(squaredMean, [&](unsigned n) { return function[n] * function[n]; });

    Judgement judgement{};
    const auto slots = static_cast<double>(bank.size());
    const double pairs = slots * (slots - 1) / 2;
    std::vector<std::vector<uint16_t>> orders;
    for (const Columns& columns : bank) orders.push_back(orderOf(columns));
    for (std::size_t a = 0; a < bank.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const ByDigits joint = variances(squaredMean, [&](unsigned n) {
                return function[orders[a][n]] * function[orders[b][n]];
            });
            for (unsigned m = 0; m <= kDigits; ++m) {
                const double ratio = std::sqrt(joint[m] / padded[m]);
                judgement.mean[m] += ratio / pairs;
                judgement.worst[m] = std::max(judgement.worst[m], ratio);
            }
        }
    }
    const auto others = static_cast<double>(bank.size() - 1);
    for (unsigned m = 0; m <= kDigits; ++m) {
        const double squared = 1 - (alike[m] / padded[m] - 1) / others;
        judgement.bound[m] = std::sqrt(std::max(0.0, squared));
    }
    return judgement;
}

} // namespace wellstrat::bank
