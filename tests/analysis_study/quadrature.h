// SPDX-License-Identifier: Apache-2.0
//
// Quadrature over the unit cube, axis by axis, for functions with jumps and kinks.

#pragma once

#include <cmath>
#include <functional>
#include <vector>

namespace wellstrat {

/// The 5-point rule of Gauss and Legendre, of degree 9: Abramowitz and Stegun 1964, table 25.4.
template <typename Function>
double gaussLegendre(const Function& f, double a, double b) {
    constexpr double kNodes[]{0.538469310105683, 0.906179845938664};
    constexpr double kWeights[]{0.568888888888889, 0.478628670499366, 0.236926885056189};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    double sum = kWeights[0] * f(middle);
    for (int i = 0; i < 2; ++i) {
        sum += kWeights[i + 1] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
    }
    return sum * half;
}

/// The rule on [a, b], where f has the values fa and fb at the ends: on both sides of a jump, if
/// bisection finds one.
template <typename Function>
double integrateCell(const Function& f, double a, double b, double fa, double fb) {
    constexpr double kJump = 1e-4;
    double low = a, high = b;
    while (std::fabs(fb - fa) > kJump && high - low > 1e-10) {
        const double middle = (low + high) / 2, value = f(middle);
        const bool left = std::fabs(value - fa) > std::fabs(fb - value);
        (left ? high : low) = middle;
        (left ? fb : fa) = value;
    }
    if (std::fabs(fb - fa) <= kJump) return gaussLegendre(f, a, b);
    return gaussLegendre(f, a, low) + gaussLegendre(f, high, b);
}

/// The integral over coordinates [axis, point.size()), given those before, each axis cut into
/// cells. Smooth functions are exact to rounding, jumps to 1e-10; a kink, as jumps
/// leave it on the axes before, costs about (0.1 / cells)^2.
inline double integrate(const std::function<double(const double*)>& f, unsigned cells,
                        std::vector<double>& point, std::size_t axis = 0) {
    const bool last = axis + 1 == point.size();
    const auto along = [&](double x) {
        point[axis] = x;
        return last ? f(point.data()) : integrate(f, cells, point, axis + 1);
    };
    double sum = 0, left = along(0);
    for (unsigned i = 0; i < cells; ++i) {
        const double a = double(i) / cells, b = double(i + 1) / cells, right = along(b);
        sum += integrateCell(along, a, b, left, right);
        left = right;
    }
    return sum;
}

} // namespace wellstrat
