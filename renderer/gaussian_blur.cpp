// SPDX-License-Identifier: Apache-2.0

#include "gaussian_blur.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wellstrat::render {
namespace {

/// Replaces `count` values that stand `stride` apart by their weighted sums. `line` is memory to
/// work in.
void sumLine(const std::vector<double>& weights, double* values, std::size_t count,
             std::size_t stride, std::vector<double>& line) {
    line.resize(count);
    for (std::size_t i = 0; i < count; ++i) line[i] = values[i * stride];
    const std::size_t reach = weights.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0;
        const std::size_t end = std::min(i + reach + 1, count);
        for (std::size_t j = std::max(i, reach) - reach; j < end; ++j) {
            sum += weights[i > j ? i - j : j - i] * line[j];
        }
        values[i * stride] = sum;
    }
}

} // namespace

GaussianBlur::GaussianBlur(double sigma, const PixelMask& mask)
    : sigma_(sigma), width_(mask.width), scales_(mask.counts.begin(), mask.counts.end()) {
    for (double x = 0; x <= 3 * sigma; ++x) {
        weights_.push_back(std::exp(-x * x / (2 * sigma * sigma)));
    }
    sum(scales_);
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        scales_[i] = mask.counts[i] ? 1 / scales_[i] : 0;
    }
}

void GaussianBlur::apply(std::vector<double>& values) const {
    if (values.size() != scales_.size()) {
        throw std::invalid_argument("a blur is for images of another size");
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (scales_[i] == 0) values[i] = 0;
    }
    sum(values);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= scales_[i];
}

void GaussianBlur::sum(std::vector<double>& values) const {
    const std::size_t height = values.size() / width_;
    std::vector<double> line;
    for (std::size_t y = 0; y < height; ++y) {
        sumLine(weights_, &values[y * width_], width_, 1, line);
    }
    for (std::size_t x = 0; x < width_; ++x) sumLine(weights_, &values[x], height, width_, line);
}

Film blurred(const Film& film, const GaussianBlur& blur) {
    std::vector<double> colors[3];
    for (int c = 0; c < 3; ++c) {
        colors[c] = meansOf(film, c);
        blur.apply(colors[c]);
    }
    Film result(film.width(), film.height());
    std::size_t i = 0;
    for (unsigned y = 0; y < film.height(); ++y) {
        for (unsigned x = 0; x < film.width(); ++x, ++i) {
            result.add(x, y, {float(colors[0][i]), float(colors[1][i]), float(colors[2][i])});
        }
    }
    return result;
}

} // namespace wellstrat::render
