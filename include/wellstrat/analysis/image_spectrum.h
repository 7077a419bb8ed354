// SPDX-License-Identifier: Apache-2.0
//
// Spectra of values on a grid of pixels, such as the errors of a picture: whether noise is white,
// or blue, with less power at low frequencies, where the eye and filters see it best.
//
// The power of the values e of W x H pixels at a frequency f, a pair of integers, is
//
//     P(f) = |sum_xy e(x, y) exp(-2 pi i (fx x / W + fy y / H))|^2 / sum_xy e(x, y)^2
//
// so that its mean over all W x H frequencies is 1 whatever the values are (Parseval), and white
// noise is flat at 1, also where its variance differs from pixel to pixel, or is 0. The grid is
// taken as it is, without a window: where opposite borders do not fit together, some power leaks
// from high to low frequencies, the less the larger the grid is.

#pragma once

#include "wellstrat/platform.h"

#include <cstddef>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The power of realizations, such as the colors of some pictures: the sum of their squared sums
/// over the sum of all squared values. One thread at a time may add; any number may read.
class WELLSTRAT_API ImagePeriodogram {
public:
    /// Throws std::invalid_argument for a width or height of 0 or above 65536.
    ImagePeriodogram(std::size_t width, std::size_t height);

    /// Adds a realization: width() * height() values, row by row, all finite. Throws
    /// std::invalid_argument for another number of them, std::bad_alloc.
    void add(const std::vector<double>& values);

    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }

    /// The power at (fx, fy), with fx in [-width() / 2, width() / 2] and fy in [-height() / 2,
    /// height() / 2], both rounded down; 0 if no value but 0 was added. That of (-fx, -fy) is the
    /// same.
    double power(int fx, int fy) const;

private:
    std::size_t width_, height_;
    double squares_ = 0;
    std::vector<double> sums_; ///< for each fy from 0, negative ones last: fx from 0 to width / 2
};

/// The mean power of a ring of frequencies.
struct RingPower {
    double frequency; ///< the middle of the ring, in cycles a pixel
    double power;     ///< 0 for a ring without frequencies
};

/// The periodogram by the length of (fx / W, fy / H), in rings of equal width from frequency 0 to
/// 0.5: as many as half of the smaller side, at least one. Frequency 0 itself, the mean of the
/// values, is left out; others below the first ring count to it.
WELLSTRAT_API std::vector<RingPower> radialPower(const ImagePeriodogram& periodogram);

} // namespace stream1
} // namespace wellstrat
