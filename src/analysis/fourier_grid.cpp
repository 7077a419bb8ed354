// SPDX-License-Identifier: Apache-2.0

#include "fourier_grid.h"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <new>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// Of FFTW only the execution of plans is safe in several threads.
std::mutex& planning() {
    static std::mutex mutex;
    return mutex;
}

} // namespace

FourierGrid::FourierGrid(std::size_t width, std::size_t height)
    : width_(width), height_(height), rowLength_(2 * (width / 2 + 1)),
      values_(fftw_alloc_real(height * rowLength_), fftw_free) {
    if (!values_) throw std::bad_alloc();
    std::fill_n(values_.get(), height * rowLength_, 0.0);
}

void FourierGrid::transform() {
    auto* const out = reinterpret_cast<fftw_complex*>(values_.get());
    fftw_plan plan = nullptr;
    {
        const std::lock_guard<std::mutex> lock(planning());
        plan = fftw_plan_dft_r2c_2d(static_cast<int>(height_), static_cast<int>(width_),
                                    values_.get(), out, FFTW_ESTIMATE);
    }
    if (plan == nullptr) throw std::bad_alloc();
    fftw_execute(plan);
    const std::lock_guard<std::mutex> lock(planning());
    fftw_destroy_plan(plan);
}

std::complex<double> FourierGrid::at(int fx, int fy) const {
    // Kept are those with fx >= 0; the others are the conjugates of their opposites.
    if (fx < 0) return std::conj(at(-fx, -fy));
    const auto y = fy < 0 ? height_ - static_cast<std::size_t>(-fy) : static_cast<std::size_t>(fy);
    const double* value = values_.get() + y * rowLength_ + 2 * static_cast<std::size_t>(fx);
    return {value[0], value[1]};
}

} // namespace stream1
} // namespace wellstrat
