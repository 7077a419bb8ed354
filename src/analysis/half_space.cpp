// SPDX-License-Identifier: Apache-2.0

#include "half_space.h"

#include <cmath>

namespace wellstrat {
inline namespace stream1 {

double halfSpaceVolume(const std::vector<double>& weights, double bound) {
    std::vector<double> positive;
    double scale = 1;
    for (const double weight : weights) {
        if (weight == 0) continue;
        if (weight < 0) bound -= weight;
        positive.push_back(std::fabs(weight));
        scale *= static_cast<double>(positive.size()) * std::fabs(weight);
    }
    if (positive.empty()) return bound > 0 ? 1 : 0;
    double sum = 0;
    for (unsigned corner = 0; corner < 1u << positive.size(); ++corner) {
        double rest = bound, sign = 1;
        for (unsigned i = 0; i < positive.size(); ++i) {
            if ((corner >> i & 1u) == 0) continue;
            rest -= positive[i];
            sign = -sign;
        }
        if (rest > 0) sum += sign * std::pow(rest, static_cast<double>(positive.size()));
    }
    return sum / scale;
}

} // namespace stream1
} // namespace wellstrat
