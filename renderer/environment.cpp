// SPDX-License-Identifier: Apache-2.0
#include "environment.h"

#include "color.h"

#include <RixShadingUtils.h>

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// The mean of the map over a pixel, as the bilinear lookup sees it: never 0 where that is not.
double brightness(const Texture& map, unsigned x, unsigned y) {
    const double weight[3] = {0.125, 0.75, 0.125};
    double sum = 0.0;
    for (unsigned i = 0; i < 9; ++i) {
        const unsigned dx = i % 3;
        const unsigned dy = i / 3;
        const unsigned column = (x + map.width() + dx - 1) % map.width();
        const unsigned row = std::clamp(y + dy, 1u, map.height()) - 1;
        sum += weight[dx] * weight[dy] * luminance(map.pixel(column, row));
    }
    return sum;
}

/// The number of the pixel at `position`, in [0, 1], of a row or column of `count`.
unsigned pixelAt(float position, unsigned count) {
    return std::min(static_cast<unsigned>(clamp01(position) * static_cast<float>(count)),
                    count - 1);
}

} // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : environment_(environment), turn_(environment.rotation * F_INVTWOPI) {
    turn_ -= std::floor(turn_);
    if (!environment.map || isBlack(environment.radiance)) return;
    for (unsigned y = 0; y <= height(); ++y) edges_.push_back(std::cos(kPi * y / height()));
    std::vector<double> weights;
    for (unsigned y = 0; y < height(); ++y) {
        std::vector<double> row;
        for (unsigned x = 0; x < width(); ++x) row.push_back(brightness(*environment.map, x, y));
        columns_.emplace_back(row);
        weights.push_back(columns_.back().total() * (edges_[y] - edges_[y + 1]));
    }
    rows_ = DiscreteDistribution(weights);
}

/// Where a direction is in the map, (0, 0) being the upper left corner and (1, 1) the lower right.
Float2 EnvironmentLight::mapPosition(Float3 direction) const {
    const float radius = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    float x = 0.5f + std::atan2(direction.x, -direction.z) * F_INVTWOPI + turn_;
    if (x > 1.0f) x -= 1.0f;
    return {x, std::atan2(radius, direction.y) * F_INVPI};
}

Float3 EnvironmentLight::radiance(Float3 direction) const {
    if (!environment_.map) return environment_.radiance;
    Float2 uv = mapPosition(direction);
    const float halfPixel = 0.5f / static_cast<float>(height()); // not across the poles
    uv.y = std::clamp(uv.y, halfPixel, 1.0f - halfPixel);
    return multiply(environment_.radiance, environment_.map->lookup(uv));
}

Float3 EnvironmentLight::sample(Float2 xi, float& pdf) const {
    const std::size_t row = rows_.choose(xi.y);
    const std::size_t column = columns_[row].choose(xi.x);
    pdf = pixelPdf(row, column);
    const double y = edges_[row] + (edges_[row + 1] - edges_[row]) * xi.y;
    const auto radius = static_cast<float>(std::sqrt((1.0 - y) * (1.0 + y)));
    const float turn = (static_cast<float>(column) + xi.x) / static_cast<float>(width());
    const float angle = F_TWOPI * (turn - 0.5f - turn_);
    return {radius * std::sin(angle), static_cast<float>(y), -radius * std::cos(angle)};
}

float EnvironmentLight::pdf(Float3 direction) const {
    if (!canSample()) return 0.0f;
    const Float2 position = mapPosition(direction);
    return pixelPdf(pixelAt(position.y, height()), pixelAt(position.x, width()));
}

float EnvironmentLight::pixelPdf(std::size_t row, std::size_t column) const {
    const double solidAngle = 2.0 * kPi * (edges_[row] - edges_[row + 1]) / width();
    const double probability = rows_.probability(row) * columns_[row].probability(column);
    return static_cast<float>(probability / solidAngle);
}

} // namespace wellstrat::render
