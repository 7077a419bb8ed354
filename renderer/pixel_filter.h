// SPDX-License-Identifier: Apache-2.0
//
// The pixel filter, by importance sampling: samples that lie as the filter says are averaged with
// weight 1. Each pixel has its own samples (Ernst et al. 2006, "Filter Importance Sampling", IEEE
// Symposium on Interactive Ray Tracing), so that no pixel depends on another.

#pragma once

#include "wellstrat/vector.h"

#include <array>

namespace wellstrat::render {

/// The Blackman-Harris window, which is close to a Gaussian but ends: Harris 1978, "On the Use of
/// Windows for Harmonic Analysis with the Discrete Fourier Transform", table 1, 4 terms, -92 dB.
class PixelFilter {
public:
    static constexpr float kRadius = 1.5f; ///< in pixels

    PixelFilter();

    /// Maps a sample in [0, 1)^2 to an offset from the center of the pixel, in pixels.
    Float2 offset(Float2 xi) const { return {offset(xi.x), offset(xi.y)}; }

private:
    static constexpr int kSteps = 256;

    float offset(float xi) const {
        const float position = xi * static_cast<float>(kSteps);
        const auto step = static_cast<unsigned>(position);
        const float within = position - static_cast<float>(step);
        return quantiles_[step] * (1.0f - within) + quantiles_[step + 1] * within;
    }

    std::array<float, kSteps + 1> quantiles_;
};

} // namespace wellstrat::render
