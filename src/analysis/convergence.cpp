// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/convergence.h"

#include "prefix_means.h"

#include <cmath>
#include <limits>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The two-sided 95 % quantile of the normal distribution.
constexpr double kNormal95 = 1.959963984540054;

void addError(ErrorSums& sums, double error) {
    const double square = error * error;
    sums.first += error;
    sums.second += square;
    sums.fourth += square * square;
}

} // namespace

ErrorSums& ErrorSums::operator+=(const ErrorSums& other) {
    first += other.first;
    second += other.second;
    fourth += other.fourth;
    return *this;
}

void addErrors(const PointSource& source, const std::vector<const Integrand*>& integrands,
               const std::vector<uint32_t>& counts, PatternRange patterns, ErrorSums* sums) {
    checkSubjects(integrands, counts, patterns.end);
    if (integrands.empty() || counts.empty()) return;
    PrefixMeans means(source, integrands[0]->domains, counts);
    for (uint64_t pattern = patterns.begin; pattern < patterns.end; ++pattern) {
        means.forEach(static_cast<uint32_t>(pattern), integrands,
                      [&](std::size_t k, std::size_t c, double mean) {
                          addError(sums[k * counts.size() + c], mean - integrands[k]->integral);
                      });
    }
}

ErrorEstimate estimateError(const ErrorSums& sums, uint64_t patterns) {
    const auto n = static_cast<double>(patterns);
    const double meanSquare = sums.second.value() / n;
    ErrorEstimate estimate{std::sqrt(meanSquare), kNaN, kNaN, sums.first.value() / n};
    if (patterns < 2) return estimate;
    if (meanSquare == 0) {
        estimate.low = estimate.high = 0;
        return estimate;
    }
    // The variance of the mean squared error; of its logarithm; half of it for the root.
    const double variance =
        std::fmax(0, sums.fourth.value() / n - meanSquare * meanSquare) / (n - 1);
    const double factor = std::exp(kNormal95 / 2 * std::sqrt(variance) / meanSquare);
    estimate.low = estimate.rmse / factor;
    estimate.high = estimate.rmse * factor;
    return estimate;
}

SlopeFit fitSlope(const std::vector<uint32_t>& counts, const std::vector<double>& rmse,
                  uint32_t firstCount) {
    std::vector<double> xs, ys;
    double meanX = 0, meanY = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] < firstCount || !(rmse[i] > 0)) continue;
        xs.push_back(std::log(counts[i]));
        ys.push_back(std::log(rmse[i]));
        meanX += xs.back();
        meanY += ys.back();
    }
    const auto points = static_cast<unsigned>(xs.size());
    if (points < 2) return {kNaN, kNaN, points};
    meanX /= points;
    meanY /= points;
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < points; ++i) {
        xx += (xs[i] - meanX) * (xs[i] - meanX);
        xy += (xs[i] - meanX) * (ys[i] - meanY);
        yy += (ys[i] - meanY) * (ys[i] - meanY);
    }
    const double slope = xy / xx;
    if (points == 2) return {slope, kNaN, points};
    return {slope, std::sqrt(std::fmax(0, yy - slope * xy) / (points - 2) / xx), points};
}

} // namespace stream1
} // namespace wellstrat
