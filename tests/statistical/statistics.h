// SPDX-License-Identifier: Apache-2.0
//
// Tail probabilities of the statistics in these tests, and how a test judges them.
//
// All seeds are fixed, so a test that passes once passes always; the rates below say how likely it
// was to fail on a flawless library when its seed was chosen.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace statistical {

/// A check fails if what it saw, or anything less likely, has a probability below this under the
/// hypothesis that all is well. These programs make under 10^4 checks between them, so the chance
/// of any false alarm is below 10^-5.
constexpr double kAlpha = 1e-9;

/// The probability that a standard normal variable is at least this far from 0.
inline double normalTail(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

/// The probability that chi-square with `freedom` degrees of freedom exceeds x: the upper
/// regularized incomplete gamma function Q(freedom / 2, x / 2), by its power series (DLMF 8.11.4)
/// or its continued fraction (DLMF 8.9.2, evaluated with Lentz's method).
inline double chiSquareTail(double x, double freedom) {
    const double a = freedom / 2, t = x / 2;
    if (t <= 0) return 1;
    const double scale = std::exp(a * std::log(t) - t - std::lgamma(a));
    if (t < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; term > sum * 1e-16; ++n) sum += term *= t / n;
        return 1 - scale * sum;
    }
    double b = t + 1 - a, c = 1e300, d = 1 / b, fraction = d;
    for (int n = 1; n < 1000000; ++n) {
        const double numerator = -n * (n - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= d * c;
        if (std::abs(d * c - 1) < 1e-15) break;
    }
    return scale * fraction;
}

inline double twoSided(double upperTail) {
    return 2 * (upperTail < 0.5 ? upperTail : 1 - upperTail);
}

/// The probability of counts at least as far from their expectations.
inline double chiSquareTail(const std::vector<uint32_t>& counts,
                            const std::vector<double>& expected) {
    double x = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double difference = counts[i] - expected[i];
        x += difference * difference / expected[i];
    }
    return chiSquareTail(x, static_cast<double>(counts.size() - 1));
}

/// The same for cells that are equally likely.
inline double uniformTail(const std::vector<uint32_t>& counts) {
    double total = 0;
    for (const uint32_t count : counts) total += count;
    const auto cells = static_cast<double>(counts.size());
    return chiSquareTail(counts, std::vector<double>(counts.size(), total / cells));
}

/// The same two-sided: counts that are too even are a fault as well.
inline double chiSquareP(const std::vector<uint32_t>& counts, const std::vector<double>& expected) {
    return twoSided(chiSquareTail(counts, expected));
}
inline double uniformP(const std::vector<uint32_t>& counts) {
    return twoSided(uniformTail(counts));
}

/// Many standard normal scores, judged together: none may be too large, and their mean square must
/// be 1, which sees small faults that are everywhere.
class Scores {
public:
    void add(double z) {
        ++count_;
        squares_ += z * z;
        if (std::abs(z) > largest_) largest_ = std::abs(z);
    }
    std::size_t count() const { return count_; }
    double largest() const { return largest_; }
    /// Of seeing a score as large as the largest, times the number of scores (Bonferroni).
    double largestP() const { return static_cast<double>(count_) * normalTail(largest_); }
    double meanSquare() const { return squares_ / static_cast<double>(count_); }
    /// Right for scores that are pairwise independent.
    double meanSquareP() const {
        return normalTail((meanSquare() - 1) * std::sqrt(static_cast<double>(count_) / 2));
    }

private:
    std::size_t count_ = 0;
    double squares_ = 0;
    double largest_ = 0;
};

} // namespace statistical
