// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/integrand_pictures.h"

#include "half_space.h"
#include "integrand_families.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The integrand at a pixel, of which u and v in [-1, 1] are all that matters.
using Field = std::function<IntegrandShape(double u, double v)>;

struct PictureRecipe {
    IntegrandPictureKind kind;
    Field at;
};

/// The half-space whose border is `offset` away from the middle of the cube along `weights`.
IntegrandShape centeredHalfSpace(const std::vector<double>& weights, double offset) {
    double bound = offset;
    for (const double weight : weights) bound += weight / 2;
    return halfSpaceShape(weights, bound);
}

IntegrandShape edge(double u, double v) {
    const double angle = 0.6 + 0.4 * u;
    return centeredHalfSpace({std::cos(angle), std::sin(angle)}, 0.25 * v);
}

constexpr double kSteepness = 3; ///< of the Gaussian

/// The integral of exp(-kSteepness (x - center)^2) over [0, 1).
double bellIntegral(double center) {
    const double root = std::sqrt(kSteepness);
    return std::sqrt(kPi) / (2 * root) * (std::erf(root * (1 - center)) + std::erf(root * center));
}

IntegrandShape gaussian(double u, double v) {
    const double a = 0.5 + 0.3 * u, b = 0.5 + 0.3 * v;
    return {bellIntegral(a) * bellIntegral(b), [a, b](const double* p) {
                const double x = p[0] - a, y = p[1] - b;
                return std::exp(-kSteepness * (x * x + y * y));
            }};
}

IntegrandShape smooth(double u, double v) {
    const double a = 1 + 0.5 * u, b = 1 + 0.5 * v;
    // The integral of x exp(r x) over [0, 1).
    const auto along = [](double r) { return ((r - 1) * std::exp(r) + 1) / (r * r); };
    return {along(a) * along(b),
            [a, b](const double* p) { return p[0] * p[1] * std::exp(a * p[0] + b * p[1]); }};
}

/// f(first domain) f(second domain).
Field squareOf(const Field& f) {
    return [f](double u, double v) {
        const IntegrandShape factor = f(u, v);
        return IntegrandShape{
            factor.integral * factor.integral,
            [value = factor.value](const double* p) { return value(p) * value(p + 2); }};
    };
}

IntegrandShape halfSpace4d(double u, double v) {
    return centeredHalfSpace({0.4 + 0.1 * u, 0.6, 0.5, 0.5 - 0.1 * v}, 0.2 * v);
}

/// Position (x, y) in the pixel, point (s, t) of a light, half hidden: an edge as wide as `width`.
/// Such a ramp is the mean of sharp edges, so its integral is the volume of a half-space with one
/// more coordinate, which moves the edge over the width.
IntegrandShape penumbra(double u, double v) {
    constexpr double kWidth = 0.3;
    const std::vector<double> weights{-0.3, -0.2 - 0.1 * u, 0.6, 0.8};
    const double bound = 0.45 + 0.2 * v;
    std::vector<double> moved = weights;
    moved.push_back(kWidth);
    return {halfSpaceVolume(moved, bound + kWidth / 2), [weights, bound](const double* p) {
                double rest = bound;
                for (std::size_t i = 0; i < weights.size(); ++i) rest -= weights[i] * p[i];
                return std::clamp(rest / kWidth + 0.5, 0.0, 1.0);
            }};
}

IntegrandShape step(double u, double v) { return halfSpaceShape({1}, 0.5 + 0.2 * u + 0.2 * v); }

IntegrandShape exponential(double u, double v) {
    const double rate = 2 + u + 0.5 * v;
    return {(1 - std::exp(-rate)) / rate,
            [rate](const double* p) { return std::exp(-rate * p[0]); }};
}

IntegrandShape halfSpace3d(double u, double v) {
    return centeredHalfSpace({0.48 + 0.1 * u, 0.6, 0.64}, 0.2 * v);
}

const std::vector<PictureRecipe>& pictureRecipes() {
    static const std::vector<PictureRecipe> recipes{
        {{"edge", {2}, "1 if (x - 1/2) cos a + (y - 1/2) sin a < v/4, else 0; a = 0.6 + 0.4 u"},
         edge},
        {{"gaussian", {2}, "exp(-3 ((x - 0.5 - 0.3 u)^2 + (y - 0.5 - 0.3 v)^2))"}, gaussian},
        {{"smooth", {2}, "x y exp((1 + u/2) x + (1 + v/2) y)"}, smooth},
        {{"edge^2", {2, 2}, "the product of two"}, squareOf(edge)},
        {{"gaussian^2", {2, 2}, "the product of two"}, squareOf(gaussian)},
        {{"smooth^2", {2, 2}, "the product of two"}, squareOf(smooth)},
        {{"half-space-4d",
          {2, 2},
          "1 if (0.4 + u/10) x + 0.6 y + 0.5 s + (0.5 - v/10) t < 1 + u/20 + 3v/20, else 0"},
         halfSpace4d},
        {{"penumbra",
          {2, 2},
          "d / 0.3 + 1/2, cut to [0, 1]; d = 0.45 + v/5 + 0.3 x + (0.2 + u/10) y - 0.6 s - 0.8 t"},
         penumbra},
        {{"step", {1}, "1 if x < 0.5 + u/5 + v/5, else 0"}, step},
        {{"exponential", {1}, "exp(-(2 + u + v/2) x)"}, exponential},
        {{"half-space-3d",
          {3},
          "1 if (0.48 + u/10) x + 0.6 y + 0.64 z < 0.86 + u/20 + v/5, else 0"},
         halfSpace3d}};
    return recipes;
}

[[noreturn]] void reject(const std::string& name) {
    std::string names;
    for (const PictureRecipe& recipe : pictureRecipes()) {
        names += (names.empty() ? "" : ", ") + recipe.kind.name;
    }
    throw std::invalid_argument("no integrand of pictures is called '" + name + "'; there are " +
                                names);
}

} // namespace

std::vector<IntegrandPictureKind> integrandPictureKinds() {
    std::vector<IntegrandPictureKind> kinds;
    for (const PictureRecipe& recipe : pictureRecipes()) kinds.push_back(recipe.kind);
    return kinds;
}

std::vector<IntegrandGroup> integrandPictureGroups() {
    return {{"2d", {"edge", "gaussian", "smooth"}},
            {"4d", {"edge^2", "gaussian^2", "smooth^2", "half-space-4d", "penumbra"}},
            {"1d-3d", {"step", "exponential", "half-space-3d"}}};
}

IntegrandPicture makeIntegrandPicture(const std::string& name, unsigned size) {
    if (size < 1 || size > kMaxPictureSize) {
        throw std::invalid_argument("pictures have 1 to " + std::to_string(kMaxPictureSize) +
                                    " pixels a side, not " + std::to_string(size));
    }
    const std::vector<PictureRecipe>& recipes = pictureRecipes();
    const auto found = std::find_if(recipes.begin(), recipes.end(),
                                    [&](const auto& recipe) { return recipe.kind.name == name; });
    if (found == recipes.end()) reject(name);
    constexpr double kPixelsPerRadian = 40;
    IntegrandPicture picture{name, found->kind.domains, size, {}};
    for (unsigned y = 0; y < size; ++y) {
        for (unsigned x = 0; x < size; ++x) {
            IntegrandShape shape =
                found->at(std::sin(x / kPixelsPerRadian), std::sin(y / kPixelsPerRadian));
            picture.pixels.push_back(
                {name, picture.domains, shape.integral, std::move(shape.value)});
        }
    }
    return picture;
}

} // namespace stream1
} // namespace wellstrat
