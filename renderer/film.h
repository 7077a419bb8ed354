// SPDX-License-Identifier: Apache-2.0
//
// Exact sums of samples, pixel by pixel. Sums are integers, so that the order in which samples
// arrive, and how they are split over threads, tiles, processes and files, changes no bit.

#pragma once

#include "wellstrat/vector.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wellstrat::render {

/// A fixed-point sum of 128 bits.
__extension__ using FixedSum = unsigned __int128;

/// Samples are clamped to these, so that 2^32 - 1 of them cannot overflow a sum.
constexpr double kMaxColor = 2147483648.0;  ///< 2^31, of each color
constexpr double kMaxLuminance = 8388608.0; ///< 2^23, of the luminance that is squared

/// What is known of one pixel.
struct PixelSums {
    FixedSum color[3] = {0, 0, 0}; ///< red, green, blue in units of 2^-64
    FixedSum square = 0;  ///< of the luminance of samples in units of 2^-48, for error estimates
    uint32_t count = 0;   ///< samples so far
    uint32_t invalid = 0; ///< of them, samples that were NaN or infinite, counted as black
    uint32_t open = 0; ///< of them, samples that met nothing, where the background is transparent
};

/// The largest width and height of a film.
constexpr unsigned kMaxFilmSize = 65536;

/// Films are rendered in tiles of this many pixels squared, from the corner (0, 0) on.
constexpr unsigned kTileSize = 16;

/// Luminance of linear Rec. 709 colors.
constexpr double luminance(double red, double green, double blue) {
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

class Film {
public:
    /// A black film. Throws std::invalid_argument for a width or height of 0 or above 65536.
    Film(unsigned width, unsigned height);

    unsigned width() const { return width_; }
    unsigned height() const { return height_; }

    /// Adds one sample; one that is open counts as transparent. Negative colors count as 0, those
    /// above kMaxColor as that, a sample with a NaN or an infinity as black; what is below the unit
    /// of the sums is dropped. Different pixels may be written by different threads at once.
    void add(unsigned x, unsigned y, Float3 sample, bool isOpen = false);

    /// Adds all of a film of the same size; std::invalid_argument otherwise. A pixel has at most
    /// 2^32 - 1 samples: more throw std::overflow_error.
    void add(const Film& other);

    const PixelSums& pixel(unsigned x, unsigned y) const { return pixels_[index(x, y)]; }
    PixelSums& pixel(unsigned x, unsigned y) { return pixels_[index(x, y)]; }

    /// All pixels row by row, the top row first.
    const std::vector<PixelSums>& pixels() const { return pixels_; }
    std::vector<PixelSums>& pixels() { return pixels_; }

    /// The mean of the samples of a pixel; black without samples.
    Float3 mean(unsigned x, unsigned y) const;

    /// The part of the samples that are not open; 1 without samples.
    float alpha(unsigned x, unsigned y) const;

    /// The estimated standard error of the mean luminance, as if samples were independent: for
    /// stratified samples it is an upper bound in most cases. Infinity below two samples.
    float standardError(unsigned x, unsigned y) const;

private:
    std::size_t index(unsigned x, unsigned y) const { return std::size_t{y} * width_ + x; }

    unsigned width_, height_;
    std::vector<PixelSums> pixels_;
};

/// Is any sample open?
bool isTransparent(const Film& film);

/// The means of one of the three colors, row by row.
std::vector<double> meansOf(const Film& film, int color);

/// Whether the sums are the same bits.
bool operator==(const PixelSums& a, const PixelSums& b);
inline bool operator!=(const PixelSums& a, const PixelSums& b) { return !(a == b); }

} // namespace wellstrat::render
