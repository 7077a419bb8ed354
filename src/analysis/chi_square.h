// SPDX-License-Identifier: Apache-2.0
//
// The chi-square distribution.

#pragma once

#include <cmath>
#include <limits>

namespace wellstrat {
inline namespace stream1 {

/// The probabilities of values below and above one; they add up to 1, and the smaller one is
/// accurate in relation to its size.
struct Tails {
    double below, above;
};

/// The tails of the chi-square distribution: the incomplete gamma functions P(a, x) and Q(a, x) of
/// a = degrees / 2 and x = chiSquare / 2. By the series of NIST DLMF 8.7.1 and, above the mean, the
/// continued fraction 8.9.2 in the form of DLMF 3.10(iii) (Steed's algorithm).
inline Tails chiSquareTails(double chiSquare, double degrees) {
    const double a = degrees / 2, x = chiSquare / 2;
    if (x <= 0) return {0, 1};
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; term > sum * epsilon; ++n) {
            term *= x / n;
            sum += term;
        }
        return {scale * sum, 1 - scale * sum};
    }
    // Q / scale = 1 / (x + 1 - a - 1 (1 - a) / (x + 3 - a - 2 (2 - a) / (x + 5 - a - ...)))
    double b = x + 1 - a, d = 1 / b, change = d, sum = d;
    for (double n = 1; std::fabs(change) > std::fabs(sum) * epsilon; ++n) {
        const double numerator = -n * (n - a);
        b += 2;
        d = 1 / (b + numerator * d);
        change *= b * d - 1;
        sum += change;
    }
    return {1 - scale * sum, scale * sum};
}

} // namespace stream1
} // namespace wellstrat
