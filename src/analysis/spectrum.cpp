// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/spectrum.h"

#include "nonuniform_fft.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// Calls visit(fx, fy) once for each pair of opposite frequencies, 0 apart.
template <class Visitor>
void visitHalfPlane(int maxFrequency, const Visitor& visit) {
    for (int fy = 0; fy <= maxFrequency; ++fy) {
        for (int fx = fy == 0 ? 1 : -maxFrequency; fx <= maxFrequency; ++fx) visit(fx, fy);
    }
}

} // namespace

Periodogram::Periodogram(int maxFrequency) : maxFrequency_(maxFrequency) {
    if (maxFrequency < 1 || maxFrequency > kMaxFrequency) {
        throw PointError("the highest frequency is " + std::to_string(maxFrequency) +
                         "; accepted are 1 to " + std::to_string(kMaxFrequency));
    }
    const auto highest = static_cast<std::size_t>(maxFrequency);
    sums_.resize((2 * highest + 1) * (highest + 1));
}

void Periodogram::add(const UnitPoints& points) {
    if (points.dims() != 2) {
        throw PointError("the points have " + std::to_string(points.dims()) +
                         " dimensions; a spectrum is that of 2");
    }
    const std::vector<std::complex<double>> sums = planeSums(points, maxFrequency_);
    const auto count = static_cast<double>(points.count());
    for (std::size_t k = 0; k < sums.size(); ++k) sums_[k] += std::norm(sums[k]) / count;
    ++realizations_;
}

double Periodogram::power(int fx, int fy) const {
    if (realizations_ == 0) return 0;
    if (fy < 0) return power(-fx, -fy);
    const int place = fy * (2 * maxFrequency_ + 1) + fx + maxFrequency_;
    return sums_[static_cast<std::size_t>(place)] / static_cast<double>(realizations_);
}

int usualMaxFrequency(std::size_t count) {
    return static_cast<int>(
        std::clamp(std::ceil(2 * std::sqrt(static_cast<double>(count))), 16.0, 511.0));
}

double decibels(double power) {
    return power > 0 ? std::max(10 * std::log10(power), kFloorDb) : kFloorDb;
}

RadialSpectrum radialSpectrum(const Periodogram& periodogram) {
    const auto rings = static_cast<std::size_t>(periodogram.maxFrequency()) + 1;
    std::vector<double> counts(rings), means(rings), squares(rings);
    visitHalfPlane(periodogram.maxFrequency(), [&](int fx, int fy) {
        const auto ring = static_cast<std::size_t>(std::lround(std::hypot(fx, fy)));
        if (ring >= rings) return;
        // Welford's update: no cancellation however small the variance.
        const double power = periodogram.power(fx, fy);
        const double off = power - means[ring];
        means[ring] += off / ++counts[ring];
        squares[ring] += off * (power - means[ring]);
    });
    RadialSpectrum result{std::vector<double>(rings), std::vector<double>(rings, kFloorDb)};
    for (std::size_t r = 1; r < rings; ++r) {
        result.mean[r] = means[r];
        const double variance = squares[r] / (counts[r] - 1);
        if (means[r] > 0) result.anisotropyDb[r] = decibels(variance / (means[r] * means[r]));
    }
    return result;
}

SpectralPeak highestPeak(const Periodogram& periodogram) {
    SpectralPeak peak{1, 0, periodogram.power(1, 0)};
    visitHalfPlane(periodogram.maxFrequency(), [&](int fx, int fy) {
        const double power = periodogram.power(fx, fy);
        if (power > peak.power) peak = {fx, fy, power};
    });
    return peak;
}

} // namespace stream1
} // namespace wellstrat
