// SPDX-License-Identifier: Apache-2.0
//
// What is left of the errors of neighboring pixels after a filter: the eye at some distance, or a
// denoiser. Independent errors (white noise) average out as those of independent numbers do; errors
// that cancel between neighbors (blue noise) leave less.
//
//     const IntegrandPicture edges = makeIntegrandPicture("edge", 76);
//     const GaussianFilter filter(2);
//     addPictureErrors({*source, cameraPattern}, {&edges}, {1, 4}, filter, {0, 20}, sums.data());
//     estimateError(sums[1], 20).rmse       // of 4 samples a pixel, over 20 pictures
//
// After Ahmed and Wonka 2020, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via
// Hierarchical Ordering of Pixels", who judge samplers by the error after a Gaussian.

#pragma once

#include "wellstrat/analysis/convergence.h"
#include "wellstrat/analysis/integrand_pictures.h"
#include "wellstrat/platform.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The pattern of pixel (x, y) in the picture `seed`. Pure; safe in any thread.
using PixelPattern = std::function<uint32_t(int x, int y, uint32_t seed)>;

/// The pattern of cameraContext (camera.h) in frame 0: pixels are independent, and pictures too.
WELLSTRAT_API uint32_t cameraPattern(int x, int y, uint32_t seed);

/// Points for each pixel of pictures. The points must outlive it.
struct PixelSource {
    const PointSource& points;
    PixelPattern patternOf;
};

/// A normalized Gaussian of `sigma` pixels, cut off at 3 sigma; with 0 it changes nothing.
class WELLSTRAT_API GaussianFilter {
public:
    /// Throws std::invalid_argument unless sigma is in [0, kMaxSigma].
    explicit GaussianFilter(double sigma);

    static constexpr double kMaxSigma = 16;

    double sigma() const { return sigma_; }
    /// How many pixels at each side of a picture have neighbors beyond it within reach.
    unsigned border() const { return static_cast<unsigned>(weights_.size() - 1); }

    /// The inner pixels of the filtered picture, row after row: those at least border() from each
    /// side. `picture` has size x size pixels, row after row; size is above 2 border().
    std::vector<double> apply(const std::vector<double>& picture, unsigned size) const;

private:
    double sigma_;
    std::vector<double> weights_; ///< of the pixels 0, 1, 2, ... away along an axis
};

/// Adds to sums[k * counts.size() + c] what is left of the errors of integrands[k] with counts[c]
/// points in each pixel after the filter, for each picture of the range of seeds. A picture adds
/// its mean error over the inner pixels, its mean squared error, and the square of that one: so
/// estimateError (convergence.h) takes pictures for patterns, and its band holds if pictures are
/// independent.
///
/// The integrands have the same domains and size, which is above 2 filter.border(); counts increase
/// strictly from 1 on: std::invalid_argument if not. `sums` must not be written to by others
/// meanwhile. Takes memory for pixels x integrands x counts numbers.
WELLSTRAT_API void addPictureErrors(const PixelSource& source,
                                    const std::vector<const IntegrandPicture*>& integrands,
                                    const std::vector<uint32_t>& counts,
                                    const GaussianFilter& filter, PatternRange seeds,
                                    ErrorSums* sums);

} // namespace stream1
} // namespace wellstrat
