// SPDX-License-Identifier: Apache-2.0
#include "pixel_filter.h"

#include <cmath>

namespace wellstrat::render {

namespace {

/// The part of the window left of x, for x in [0, 1] of its width: the integral of
/// 1 - sum of a_k cos(2 pi k x) over its mean, in closed form.
double cumulative(double x) {
    constexpr double kPi = 3.14159265358979323846;
    constexpr double kTerms[4] = {0.35875, -0.48829, 0.14128, -0.01168};
    double sum = x;
    for (int k = 1; k < 4; ++k) {
        sum += kTerms[k] / kTerms[0] * std::sin(2.0 * kPi * k * x) / (2.0 * kPi * k);
    }
    return sum;
}

/// The x with cumulative(x) = part, by bisection.
double quantile(double part) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 53; ++i) {
        const double middle = 0.5 * (low + high);
        (cumulative(middle) < part ? low : high) = middle;
    }
    return high;
}

} // namespace

PixelFilter::PixelFilter() : quantiles_() {
    for (int i = 0; i <= kSteps; ++i) {
        const double x = i == 0 ? 0.0 : i == kSteps ? 1.0 : quantile(double{1} * i / kSteps);
        quantiles_[static_cast<unsigned>(i)] = static_cast<float>((2.0 * x - 1.0) * kRadius);
    }
}

} // namespace wellstrat::render
