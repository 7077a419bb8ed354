// SPDX-License-Identifier: Apache-2.0

#include "integrand_families.h"

#include "half_space.h"
#include "wellstrat/hash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr double kPi = 3.14159265358979323846;

using Value = std::function<double(const double*)>;
using Maker = std::function<IntegrandShape(unsigned)>;

/// The integrand that is 1 where `inside` holds and 0 elsewhere.
template <typename Inside>
Value indicator(Inside inside) {
    return [inside](const double* p) { return inside(p) ? 1.0 : 0.0; };
}

template <typename Factor>
Value productOfCoordinates(unsigned dims, Factor factor) {
    return [dims, factor](const double* p) {
        double product = 1;
        for (unsigned i = 0; i < dims; ++i) product *= factor(p[i]);
        return product;
    };
}

double power(double base, unsigned exponent) { return std::pow(base, double(exponent)); }

Maker fixed(double integral, Value value) {
    return [shape = IntegrandShape{integral, std::move(value)}](unsigned) { return shape; };
}

Maker step() {
    return fixed(1 / kPi, indicator([](const double* p) { return p[0] < 1 / kPi; }));
}

/// A circle of area 1/2 in the square; in 3D an octant of a ball of volume 1/2.
Maker disk(unsigned dims) {
    const double squaredRadius = dims == 2 ? 2 / kPi : std::pow(3 / kPi, 2.0 / 3);
    return fixed(0.5, indicator([dims, squaredRadius](const double* p) {
                     double sum = 0;
                     for (unsigned i = 0; i < dims; ++i) sum += p[i] * p[i];
                     return sum < squaredRadius;
                 }));
}

/// Coordinates in ascending order.
Maker triangle(unsigned dims) {
    return fixed(dims == 2 ? 1.0 / 2 : 1.0 / 6, indicator([dims](const double* p) {
                     return p[0] < p[1] && (dims == 2 || p[1] < p[2]);
                 }));
}

Maker gaussian(unsigned dims) {
    return fixed(power(std::sqrt(kPi) / 2 * std::erf(1.0), dims),
                 productOfCoordinates(dims, [](double x) { return std::exp(-x * x); }));
}

Maker multilinear(unsigned dims) {
    return fixed(power(0.5, dims), productOfCoordinates(dims, [](double x) { return x; }));
}

/// All derivatives exist and none vanishes: scrambled nets have an RMSE of N^(-3/2), times
/// (log N)^((s-1)/2). Owen 1997, "Scrambled Net Variance for Integrals of Smooth Functions".
Maker smooth(unsigned dims) {
    return fixed(1, productOfCoordinates(dims, [](double x) { return x * std::exp(x); }));
}

Value halfSpace(const std::vector<double>& weights, double bound) {
    return indicator([weights, bound](const double* p) {
        double sum = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * p[i];
        return sum < bound;
    });
}

Maker fixedHalfSpace(const std::vector<double>& weights, double bound) {
    return [shape = halfSpaceShape(weights, bound)](unsigned) { return shape; };
}

IntegrandShape edge(unsigned degrees) {
    // Multiples of 90 degrees have an exact 0, which the formula of the volume needs.
    const bool vertical = degrees % 180 == 0, horizontal = degrees % 180 == 90;
    const double angle = degrees * kPi / 180;
    const double c = horizontal ? 0 : std::cos(angle), s = vertical ? 0 : std::sin(angle);
    return halfSpaceShape({c, s}, 0.1 + (c + s) / 2);
}

/// sin(t) / t.
double sinc(double t) { return t == 0 ? 1 : std::sin(t) / t; }

constexpr std::array<std::array<double, 3>, 3> kWaveDirections{
    {{1, 0, 0}, {0.6, 0.8, 0}, {0.48, 0.6, 0.64}}};

/// A plane wave with a phase of 1 rad. Its integral is that of exp(i (w.x + 1)), factor by factor.
Maker sine(unsigned dims) {
    return [dims](unsigned frequency) {
        std::array<double, 3> w{};
        double phase = 1, amplitude = 1;
        for (unsigned i = 0; i < dims; ++i) {
            w[i] = 2 * kPi * frequency * kWaveDirections[dims - 1][i];
            phase += w[i] / 2;
            amplitude *= sinc(w[i] / 2);
        }
        const auto value = [dims, w](const double* p) {
            double t = 1;
            for (unsigned i = 0; i < dims; ++i) t += w[i] * p[i];
            return 0.5 + 0.5 * std::cos(t);
        };
        return IntegrandShape{0.5 + 0.5 * amplitude * std::cos(phase), value};
    };
}

/// The box whose corners are hashes of its number.
Maker box(unsigned dims) {
    return [dims](unsigned number) {
        std::array<double, 3> low{}, high{};
        double volume = 1;
        for (unsigned i = 0; i < dims; ++i) {
            const uint32_t seed = hashPair(dims, number);
            low[i] = hashPair(seed, 2 * i) * 0x1p-32;
            high[i] = hashPair(seed, 2 * i + 1) * 0x1p-32;
            if (low[i] > high[i]) std::swap(low[i], high[i]);
            volume *= high[i] - low[i];
        }
        return IntegrandShape{volume, indicator([dims, low, high](const double* p) {
                                  for (unsigned i = 0; i < dims; ++i) {
                                      if (p[i] < low[i] || p[i] >= high[i]) return false;
                                  }
                                  return true;
                              })};
    };
}

/// How much of [0, t) has an odd integer part.
double oddLength(double t) {
    const double periods = std::floor(t / 2);
    return periods + std::max(0.0, t - 2 * periods - 1);
}

IntegrandShape checkerboard(unsigned zoom) {
    const double span = zoom * std::sqrt(2.0);
    const std::array<double, 2> offset{0.3, 0.6};
    std::array<double, 2> odd{};
    for (unsigned i = 0; i < 2; ++i) {
        odd[i] = (oddLength(offset[i] + span) - oddLength(offset[i])) / span;
    }
    const auto value = indicator([span, offset](const double* p) {
        const double cells =
            std::floor(span * p[0] + offset[0]) + std::floor(span * p[1] + offset[1]);
        return std::fmod(cells, 2) == 1;
    });
    return {odd[0] * (1 - odd[1]) + odd[1] * (1 - odd[0]), value};
}

std::vector<IntegrandRecipe> makeRecipes() {
    std::vector<IntegrandRecipe> recipes;
    const auto add = [&](const char* name, DomainDims domains, const char* formula, Maker make) {
        recipes.push_back({{name, std::move(domains), formula, false, 0, 0}, std::move(make)});
    };
    const auto addFamily = [&](const char* name, DomainDims domains, const char* formula,
                               unsigned first, unsigned last, Maker make) {
        recipes.push_back(
            {{name, std::move(domains), formula, true, first, last}, std::move(make)});
    };
    constexpr unsigned kMaxFrequency = 1024, kMaxBox = 999999;
    add("step-1d", {1}, "1 if x < 1/pi, else 0", step());
    add("linear", {1}, "x", multilinear(1));
    add("gaussian-1d", {1}, "exp(-x^2)", gaussian(1));
    add("smooth-1d", {1}, "x exp(x)", smooth(1));
    addFamily("sine-1d-K", {1}, "(1 + cos(2 pi K x + 1)) / 2", 1, kMaxFrequency, sine(1));
    addFamily("box-1d-K", {1}, "1 in the K-th random interval, else 0", 0, kMaxBox, box(1));
    add("disk", {2}, "1 if x^2 + y^2 < 2/pi, else 0", disk(2));
    add("triangle", {2}, "1 if x < y, else 0", triangle(2));
    add("step", {2}, "1 if x < 1/pi, else 0", step());
    add("gaussian", {2}, "exp(-x^2 - y^2)", gaussian(2));
    add("bilinear", {2}, "x y", multilinear(2));
    add("smooth", {2}, "x exp(x) y exp(y)", smooth(2));
    addFamily("edge-A", {2}, "1 if (x - 1/2) cos(A deg) + (y - 1/2) sin(A deg) < 1/10, else 0", 0,
              359, edge);
    addFamily("sine-K", {2}, "(1 + cos(2 pi K (3x/5 + 4y/5) + 1)) / 2", 1, kMaxFrequency, sine(2));
    addFamily("box-K", {2}, "1 in the K-th random rectangle, else 0", 0, kMaxBox, box(2));
    addFamily("checkerboard-Z", {2},
              "(floor(sqrt(2) Z x + 0.3) + floor(sqrt(2) Z y + 0.6)) modulo 2", 1, kMaxFrequency,
              checkerboard);
    add("disk-3d", {3}, "1 if (x^2 + y^2 + z^2)^(3/2) < 3/pi, else 0", disk(3));
    add("triangle-3d", {3}, "1 if x < y < z, else 0", triangle(3));
    add("edge-3d", {3}, "1 if 0.48 x + 0.6 y + 0.64 z < 0.8, else 0",
        fixedHalfSpace({0.48, 0.6, 0.64}, 0.8));
    add("gaussian-3d", {3}, "exp(-x^2 - y^2 - z^2)", gaussian(3));
    add("trilinear", {3}, "x y z", multilinear(3));
    add("smooth-3d", {3}, "x exp(x) y exp(y) z exp(z)", smooth(3));
    addFamily("sine-3d-K", {3}, "(1 + cos(2 pi K (0.48 x + 0.6 y + 0.64 z) + 1)) / 2", 1,
              kMaxFrequency, sine(3));
    addFamily("box-3d-K", {3}, "1 in the K-th random box, else 0", 0, kMaxBox, box(3));
    add("soft-shadow-line", {2, 1},
        "pixel (x, y), point u of a line light: 1 if u < 0.1 + 0.5 x + 0.3 y, else 0",
        fixedHalfSpace({-0.5, -0.3, 1}, 0.1));
    add("soft-shadow", {2, 2},
        "pixel (x, y), point (u, v) of a light: 1 if 0.6 u + 0.8 v < 0.4 + 0.5 x + 0.3 y, else 0",
        fixedHalfSpace({-0.5, -0.3, 0.6, 0.8}, 0.4));
    return recipes;
}

} // namespace

IntegrandShape halfSpaceShape(const std::vector<double>& weights, double bound) {
    return {halfSpaceVolume(weights, bound), halfSpace(weights, bound)};
}

const std::vector<IntegrandRecipe>& integrandRecipes() {
    static const std::vector<IntegrandRecipe> recipes = makeRecipes();
    return recipes;
}

} // namespace stream1
} // namespace wellstrat
