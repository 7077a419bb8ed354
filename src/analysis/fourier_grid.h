// SPDX-License-Identifier: Apache-2.0
//
// The Fourier transform of real values on a grid, by FFTW.

#pragma once

#include <complex>
#include <cstddef>
#include <memory>

namespace wellstrat {
inline namespace stream1 {

/// A grid that is transformed in place: first it holds values, then their sums
/// sum_xy value(x, y) exp(-2 pi i (fx x / width + fy y / height)).
class FourierGrid {
public:
    /// All values 0. Width and height are from 1 to 2^30. Throws std::bad_alloc.
    FourierGrid(std::size_t width, std::size_t height);

    /// The `width` values of a row, before the transform.
    double* row(std::size_t y) { return values_.get() + y * rowLength_; }

    /// Once. Any number of threads may transform grids of their own.
    void transform();

    /// After the transform, the sum of a frequency: fx in [-width / 2, width / 2] and fy in
    /// [-height / 2, height / 2].
    std::complex<double> at(int fx, int fy) const;

private:
    std::size_t width_, height_, rowLength_;
    std::unique_ptr<double, void (*)(void*)> values_;
};

} // namespace stream1
} // namespace wellstrat
