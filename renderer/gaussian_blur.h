// SPDX-License-Identifier: Apache-2.0
//
// A Gaussian blur among some of the pixels of a picture, with pictures of doubles and exact
// borders. OpenImageIO's would round to floats, end after two standard deviations, and repeat the
// border.

#pragma once

#include "film.h"
#include "pixel_mask.h"

#include <cstddef>
#include <vector>

namespace wellstrat::render {

/// A blurred pixel is the weighted mean of the pixels of the mask, with the weights
/// exp(-(dx^2 + dy^2) / (2 sigma^2)) for |dx| and |dy| up to 3 sigma. What is outside of the
/// picture or of the mask is not there: the weights of the others are scaled to sum 1. Constants
/// are kept.
class GaussianBlur {
public:
    /// `sigma`, in pixels, is above 0.
    GaussianBlur(double sigma, const PixelMask& mask);

    double sigma() const { return sigma_; }

    /// Blurs one value for each pixel, row by row, in place. Those outside of the mask become 0.
    /// Throws std::invalid_argument for another number of them. Any number of threads may call.
    void apply(std::vector<double>& values) const;

private:
    /// Sums with the weights, along rows, then along columns.
    void sum(std::vector<double>& values) const;

    double sigma_;
    std::size_t width_;
    std::vector<double> weights_; ///< at distances 0, 1, ...; their scale is arbitrary
    std::vector<double> scales_;  ///< for each pixel: 1 over the sum of its weights, 0 if masked
};

/// The means of the film, blurred, as a film of one sample a pixel. Throws std::invalid_argument if
/// the blur is for another size.
Film blurred(const Film& film, const GaussianBlur& blur);

} // namespace wellstrat::render
