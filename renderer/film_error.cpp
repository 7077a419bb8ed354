// SPDX-License-Identifier: Apache-2.0

#include "film_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr double kDark = 0.01;

/// Weights of a Gaussian at distances 0, 1, ... in pixels; their scale is arbitrary.
std::vector<double> blurWeights() {
    std::vector<double> weights;
    for (double x = 0; x <= 3 * kErrorBlur; ++x) {
        weights.push_back(std::exp(-x * x / (2 * kErrorBlur * kErrorBlur)));
    }
    return weights;
}

/// Blurs `count` values that stand `stride` apart, in place. `line` is memory to work in.
void blurLine(const std::vector<double>& weights, double* values, std::size_t count,
              std::size_t stride, std::vector<double>& line) {
    line.resize(count);
    for (std::size_t i = 0; i < count; ++i) line[i] = values[i * stride];
    const std::size_t reach = weights.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0, weight = 0;
        const std::size_t end = std::min(i + reach + 1, count);
        for (std::size_t j = std::max(i, reach) - reach; j < end; ++j) {
            const double w = weights[i > j ? i - j : j - i];
            sum += w * line[j];
            weight += w;
        }
        values[i * stride] = sum / weight;
    }
}

/// A Gaussian is separable: rows, then columns.
void blur(std::vector<double>& values, std::size_t width, std::size_t height) {
    const std::vector<double> weights = blurWeights();
    std::vector<double> line;
    for (std::size_t y = 0; y < height; ++y) {
        blurLine(weights, &values[y * width], width, 1, line);
    }
    for (std::size_t x = 0; x < width; ++x) blurLine(weights, &values[x], height, width, line);
}

double sumOfSquares(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return sum;
}

} // namespace

FilmError filmError(const Film& film, const Film& reference) {
    const unsigned width = film.width(), height = film.height();
    if (reference.width() != width || reference.height() != height) {
        throw std::invalid_argument("images of different sizes cannot be compared");
    }
    double squares = 0, relative = 0, filtered = 0;
    std::vector<double> differences(std::size_t{width} * height);
    for (int c = 0; c < 3; ++c) {
        for (unsigned y = 0; y < height; ++y) {
            for (unsigned x = 0; x < width; ++x) {
                const double right{reference.mean(x, y)[c]};
                const double d = double{film.mean(x, y)[c]} - right;
                differences[std::size_t{y} * width + x] = d;
                relative += d * d / (right * right + kDark);
            }
        }
        squares += sumOfSquares(differences);
        blur(differences, width, height);
        filtered += sumOfSquares(differences);
    }
    const double count = 3.0 * static_cast<double>(differences.size());
    return {std::sqrt(squares / count), relative / count, std::sqrt(filtered / count)};
}

} // namespace wellstrat::render
