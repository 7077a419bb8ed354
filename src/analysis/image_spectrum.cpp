// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/image_spectrum.h"

#include "fourier_grid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr std::size_t kMaxSide = 65536;

/// The integers f with -size / 2 < f <= size / 2, one for each frequency of an axis.
struct Axis {
    explicit Axis(std::size_t size) : last(static_cast<int>(size / 2)) {
        first = last + 1 - static_cast<int>(size);
    }
    int first, last;
};

} // namespace

ImagePeriodogram::ImagePeriodogram(std::size_t width, std::size_t height)
    : width_(width), height_(height) {
    if (width < 1 || width > kMaxSide || height < 1 || height > kMaxSide) {
        throw std::invalid_argument(
            "a grid of " + std::to_string(width) + "x" + std::to_string(height) +
            " pixels; accepted are sides of 1 to " + std::to_string(kMaxSide));
    }
    sums_.resize((width / 2 + 1) * height);
}

void ImagePeriodogram::add(const std::vector<double>& values) {
    if (values.size() != width_ * height_) {
        throw std::invalid_argument(std::to_string(values.size()) + " values for " +
                                    std::to_string(width_) + "x" + std::to_string(height_) +
                                    " pixels");
    }
    FourierGrid grid(width_, height_);
    for (std::size_t y = 0; y < height_; ++y) {
        std::copy_n(values.data() + y * width_, width_, grid.row(y));
    }
    for (const double value : values) squares_ += value * value;
    grid.transform();
    const Axis across(width_), down(height_);
    auto sum = sums_.begin();
    for (std::size_t y = 0; y < height_; ++y) {
        const int fy = static_cast<int>(y) <= down.last ? static_cast<int>(y)
                                                        : static_cast<int>(y) - int(height_);
        for (int fx = 0; fx <= across.last; ++fx) *sum++ += std::norm(grid.at(fx, fy));
    }
}

double ImagePeriodogram::power(int fx, int fy) const {
    if (squares_ == 0) return 0;
    if (fx < 0) return power(-fx, -fy);
    const auto y = fy < 0 ? height_ - static_cast<std::size_t>(-fy) : static_cast<std::size_t>(fy);
    return sums_[y * (width_ / 2 + 1) + static_cast<std::size_t>(fx)] / squares_;
}

std::vector<RingPower> radialPower(const ImagePeriodogram& periodogram) {
    const auto width = static_cast<double>(periodogram.width());
    const auto height = static_cast<double>(periodogram.height());
    const std::size_t count =
        std::max<std::size_t>(std::min(periodogram.width(), periodogram.height()) / 2, 1);
    const double step = 0.5 / static_cast<double>(count);
    std::vector<double> sums(count + 1), frequencies(count + 1);
    const Axis across(periodogram.width()), down(periodogram.height());
    for (int fy = down.first; fy <= down.last; ++fy) {
        for (int fx = across.first; fx <= across.last; ++fx) {
            if (fx == 0 && fy == 0) continue;
            const double length = std::hypot(fx / width, fy / height);
            const auto ring = static_cast<std::size_t>(std::max(std::lround(length / step), 1L));
            if (ring > count) continue;
            sums[ring] += periodogram.power(fx, fy);
            ++frequencies[ring];
        }
    }
    std::vector<RingPower> rings;
    for (std::size_t r = 1; r <= count; ++r) {
        rings.push_back(
            {static_cast<double>(r) * step, frequencies[r] == 0 ? 0 : sums[r] / frequencies[r]});
    }
    return rings;
}

} // namespace stream1
} // namespace wellstrat
