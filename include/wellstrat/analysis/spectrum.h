// SPDX-License-Identifier: Apache-2.0
//
// Spectra of points in the plane: how much of each frequency there is in them.
//
// The power of N points x_j at a frequency f, a pair of integers, is
//
//     P(f) = |sum_j exp(-2 pi i f.x_j)|^2 / N
//
// so that independent uniform points have an expectation of exactly 1 at all frequencies but 0.
// Low power at low frequencies is what makes an error small; a spike makes a pattern visible.
// Ulichney 1987, "Digital Halftoning", chapter 3, for periodogram, radial mean and anisotropy.

#pragma once

#include "wellstrat/analysis/unit_points.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The mean power of realizations, such as the patterns of one generator, for frequencies with
/// components up to maxFrequency(). One thread at a time may add; any number may read.
class WELLSTRAT_API Periodogram {
public:
    static constexpr int kMaxFrequency = 1023;

    /// Throws PointError unless maxFrequency is in [1, kMaxFrequency].
    explicit Periodogram(int maxFrequency);

    /// Adds a realization, 2D points of any number. Throws PointError for other dimensions.
    ///
    /// The sums are exact but for rounding and 1e-11 of the number of points: a Fourier transform
    /// of non-uniform points by Gaussian gridding, twice oversampled, 12 cells to each side
    /// (Greengard, Lee 2004, "Accelerating the nonuniform fast Fourier transform", SIAM Review 46,
    /// 443-454). Points are not moved to a grid. Time: 576 steps a point and a transform of
    /// (4 maxFrequency + 4)^2 values, which take 16 bytes each.
    void add(const UnitPoints& points);

    int maxFrequency() const { return maxFrequency_; }
    std::size_t realizations() const { return realizations_; }

    /// The mean power at (fx, fy), components in [-maxFrequency(), maxFrequency()]; 0 if nothing
    /// was added. That of (-fx, -fy) is the same; at (0, 0) it is the number of points.
    double power(int fx, int fy) const;

private:
    int maxFrequency_;
    std::size_t realizations_ = 0;
    std::vector<double> sums_; ///< fy from 0; in it fx from -maxFrequency
};

/// A frequency that resolves what the spacing of `count` points can show: about 2 sqrt(count),
/// between 16 and 511.
WELLSTRAT_API int usualMaxFrequency(std::size_t count);

/// The periodogram by distance from frequency 0. Element r stands for the frequencies whose length,
/// rounded, is r; element 0 is 0.
struct RadialSpectrum {
    std::vector<double> mean;
    /// The variance among these frequencies over the square of their mean, in dB: for M
    /// realizations of independent points -10 log10 M, give or take its sampling error; higher
    /// where directions differ. kFloorDb where there is no power at all.
    std::vector<double> anisotropyDb;
};

/// What stands for 0 in dB.
constexpr double kFloorDb = -200;

/// 10 log10 of a power, at least kFloorDb.
WELLSTRAT_API double decibels(double power);

WELLSTRAT_API RadialSpectrum radialSpectrum(const Periodogram& periodogram);

/// A frequency and its power.
struct SpectralPeak {
    int fx, fy; ///< fy >= 0
    double power;
};

/// The frequency other than 0 with the most power.
WELLSTRAT_API SpectralPeak highestPeak(const Periodogram& periodogram);

} // namespace stream1
} // namespace wellstrat
