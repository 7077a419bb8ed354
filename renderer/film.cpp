// SPDX-License-Identifier: Apache-2.0

#include "film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wellstrat::render {
namespace {

constexpr double kColorUnits = 18446744073709551616.0; // 2^64
constexpr double kSquareUnits = 281474976710656.0;     // 2^48

/// `value` in [0, 2^79], scaled by a power of two, without its fraction. Exact before that.
FixedSum toFixed(double value, double units) { return static_cast<FixedSum>(value * units); }

double toDouble(FixedSum sum, double units) { return static_cast<double>(sum) / units; }

float clampColor(float color) { return std::clamp(color, 0.0f, static_cast<float>(kMaxColor)); }

bool isFinite(Float3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double meanOf(const PixelSums& sums, int channel) {
    return sums.count == 0 ? 0.0 : toDouble(sums.color[channel], kColorUnits) / sums.count;
}

unsigned checkedSize(unsigned size) {
    if (size > 0 && size <= kMaxFilmSize) return size;
    throw std::invalid_argument("the width and the height of a film are from 1 to 65536 pixels");
}

} // namespace

Film::Film(unsigned width, unsigned height)
    : width_(checkedSize(width)), height_(checkedSize(height)),
      pixels_(std::size_t{width} * height) {}

void Film::add(unsigned x, unsigned y, Float3 sample, bool isOpen) {
    PixelSums& sums = pixel(x, y);
    ++sums.count;
    sums.open += isOpen ? 1 : 0;
    if (!isFinite(sample)) {
        ++sums.invalid;
        return;
    }
    for (int c = 0; c < 3; ++c) {
        sample[c] = clampColor(sample[c]);
        sums.color[c] += toFixed(double{sample[c]}, kColorUnits);
    }
    const double brightness =
        std::min(luminance(double{sample.x}, double{sample.y}, double{sample.z}), kMaxLuminance);
    sums.square += toFixed(brightness * brightness, kSquareUnits);
}

void Film::add(const Film& other) {
    if (other.width_ != width_ || other.height_ != height_) {
        throw std::invalid_argument("films of different sizes cannot be added");
    }
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        PixelSums& sums = pixels_[i];
        const PixelSums& more = other.pixels_[i];
        if (more.count > std::numeric_limits<uint32_t>::max() - sums.count) {
            throw std::overflow_error("a pixel has at most 2^32 - 1 samples");
        }
        for (int c = 0; c < 3; ++c) sums.color[c] += more.color[c];
        sums.square += more.square;
        sums.count += more.count;
        sums.invalid += more.invalid;
        sums.open += more.open;
    }
}

Float3 Film::mean(unsigned x, unsigned y) const {
    const PixelSums& sums = pixel(x, y);
    return {static_cast<float>(meanOf(sums, 0)), static_cast<float>(meanOf(sums, 1)),
            static_cast<float>(meanOf(sums, 2))};
}

float Film::alpha(unsigned x, unsigned y) const {
    const PixelSums& sums = pixel(x, y);
    if (sums.count == 0) return 1;
    return static_cast<float>(1 - static_cast<double>(sums.open) / sums.count);
}

float Film::standardError(unsigned x, unsigned y) const {
    const PixelSums& sums = pixel(x, y);
    if (sums.count < 2) return std::numeric_limits<float>::infinity();
    const double mean = luminance(meanOf(sums, 0), meanOf(sums, 1), meanOf(sums, 2));
    const double variance = toDouble(sums.square, kSquareUnits) / sums.count - mean * mean;
    return static_cast<float>(std::sqrt(std::max(variance, 0.0) / (sums.count - 1)));
}

bool isTransparent(const Film& film) {
    return std::any_of(film.pixels().begin(), film.pixels().end(),
                       [](const PixelSums& sums) { return sums.open > 0; });
}

std::vector<double> meansOf(const Film& film, int color) {
    std::vector<double> means;
    means.reserve(film.pixels().size());
    for (unsigned y = 0; y < film.height(); ++y) {
        for (unsigned x = 0; x < film.width(); ++x) means.emplace_back(film.mean(x, y)[color]);
    }
    return means;
}

bool operator==(const PixelSums& a, const PixelSums& b) {
    return std::equal(a.color, a.color + 3, b.color) && a.square == b.square &&
           a.count == b.count && a.invalid == b.invalid && a.open == b.open;
}

} // namespace wellstrat::render
