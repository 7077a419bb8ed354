// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/convergence.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The two-sided 95 % quantile of the normal distribution.
constexpr double kNormal95 = 1.959963984540054;

void checkArguments(const std::vector<const Integrand*>& integrands,
                    const std::vector<uint32_t>& counts, PatternRange patterns) {
    for (const Integrand* integrand : integrands) {
        if (integrand->domains != integrands[0]->domains) {
            throw std::invalid_argument("the integrands of one call must have the same domains");
        }
    }
    uint32_t last = 0;
    for (const uint32_t count : counts) {
        if (count <= last) {
            throw std::invalid_argument("the numbers of points must increase, from 1 on");
        }
        last = count;
    }
    if (patterns.end > uint64_t{1} << 32) {
        throw std::invalid_argument("there are no patterns from 2^32 on");
    }
}

void addError(ErrorSums& sums, double error) {
    const double square = error * error;
    sums.first += error;
    sums.second += square;
    sums.fourth += square * square;
}

/// The errors of one pattern.
class PatternErrors {
public:
    PatternErrors(const PointSource& source, const std::vector<const Integrand*>& integrands,
                  const std::vector<uint32_t>& counts, ErrorSums* sums)
        : source_(source), integrands_(integrands), counts_(counts), sums_(sums),
          dims_(totalDims(integrands[0]->domains)), points_(std::size_t{counts.back()} * dims_) {}

    void add(uint32_t pattern) {
        if (source_.isProgressive()) {
            draw(pattern, counts_.back());
            for (std::size_t k = 0; k < integrands_.size(); ++k) addPrefixes(k);
            return;
        }
        for (std::size_t c = 0; c < counts_.size(); ++c) {
            draw(pattern, counts_[c]);
            for (std::size_t k = 0; k < integrands_.size(); ++k) {
                add(k, c, sumOfValues(k, 0, counts_[c], 0));
            }
        }
    }

private:
    void draw(uint32_t pattern, uint32_t count) {
        source_.draw(pattern, integrands_[0]->domains, count, points_.data());
    }

    /// `sum` and the values at points [begin, end), added in order.
    double sumOfValues(std::size_t k, uint32_t begin, uint32_t end, double sum) const {
        const auto& value = integrands_[k]->value;
        for (uint32_t i = begin; i < end; ++i) sum += value(&points_[std::size_t{i} * dims_]);
        return sum;
    }

    void addPrefixes(std::size_t k) {
        double sum = 0;
        uint32_t done = 0;
        for (std::size_t c = 0; c < counts_.size(); ++c) {
            sum = sumOfValues(k, done, counts_[c], sum);
            done = counts_[c];
            add(k, c, sum);
        }
    }

    void add(std::size_t k, std::size_t c, double sum) {
        addError(sums_[k * counts_.size() + c], sum / counts_[c] - integrands_[k]->integral);
    }

    const PointSource& source_;
    const std::vector<const Integrand*>& integrands_;
    const std::vector<uint32_t>& counts_;
    ErrorSums* sums_;
    unsigned dims_;
    std::vector<double> points_;
};

} // namespace

ErrorSums& ErrorSums::operator+=(const ErrorSums& other) {
    first += other.first;
    second += other.second;
    fourth += other.fourth;
    return *this;
}

void addErrors(const PointSource& source, const std::vector<const Integrand*>& integrands,
               const std::vector<uint32_t>& counts, PatternRange patterns, ErrorSums* sums) {
    checkArguments(integrands, counts, patterns);
    if (integrands.empty() || counts.empty()) return;
    PatternErrors errors(source, integrands, counts, sums);
    for (uint64_t pattern = patterns.begin; pattern < patterns.end; ++pattern) {
        errors.add(static_cast<uint32_t>(pattern));
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
