// SPDX-License-Identifier: Apache-2.0
//
// Small pictures for tests of what the renderer computes, and how to judge them. What a test checks
// fails by chance with a probability below statistical::kAlpha.

#pragma once

#include "renderer/framing.h"
#include "renderer/render.h"
#include "renderer/scenes/parts.h"
#include "statistical/statistics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace wellstrat::render {

inline Film renderFilm(const Scene& scene, unsigned side, unsigned samples,
                       const SamplingOptions& options = {}) {
    const Renderer renderer(scene, side, side, options);
    Film film(side, side);
    renderer.render({0, side, 0, samples}, film, std::atomic<bool>{false}, [](uint64_t) {});
    return film;
}

inline SamplingOptions optionsOfDepth(unsigned depth) {
    SamplingOptions options;
    options.depth = depth;
    return options;
}

/// A camera for which a picture of few pixels is practically one point: it looks from `eye` at
/// `target`, and its picture is 10^-4 as wide as far away.
inline Camera pointCamera(Float3 eye, Float3 target) {
    const Float3 view = target - eye;
    const Float3 up = std::fabs(view.y) > 0.9f * view.Length() ? Float3(1, 0, 0) : Float3(0, 1, 0);
    return lookAt(eye, target, up, 1e-4f);
}

/// A mean and its standard error.
struct Estimate {
    double mean, error;
};

inline Estimate estimate(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double v : values) sum += v;
    const auto n = static_cast<double>(values.size());
    for (const double v : values) squares += (v - sum / n) * (v - sum / n);
    return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

/// The mean of a channel over the pixels, which have independent samples.
inline Estimate channelMean(const Film& film, int channel) {
    std::vector<double> values;
    for (unsigned y = 0; y < film.height(); ++y)
        for (unsigned x = 0; x < film.width(); ++x) {
            EXPECT_EQ(film.pixel(x, y).invalid, 0u);
            values.push_back(film.mean(x, y)[channel]);
        }
    return estimate(values);
}

/// The mean of all pixels is `expected`: within what chance allows, and within `tolerance` of it
/// relatively, which also bounds how noisy the test may be.
inline void expectMean(const Film& film, Float3 expected, double tolerance) {
    for (int c = 0; c < 3; ++c) {
        const Estimate mean = channelMean(film, c);
        const double difference = mean.mean - expected[c];
        const double rounding = 1e-5 * expected[c];
        EXPECT_LT(std::fabs(difference), tolerance * expected[c] + 1e-12) << "channel " << c;
        EXPECT_GE(statistical::normalTail(std::max(0.0, std::fabs(difference) - rounding) /
                                          (mean.error + 1e-30)),
                  statistical::kAlpha)
            << "channel " << c << ": " << mean.mean << " +- " << mean.error << ", expected "
            << expected[c];
    }
}

/// Two pictures with independent samples have the same mean, pixel by pixel.
inline void expectSameMean(const Film& a, const Film& b) {
    for (int c = 0; c < 3; ++c) {
        std::vector<double> differences;
        for (unsigned y = 0; y < a.height(); ++y)
            for (unsigned x = 0; x < a.width(); ++x)
                differences.push_back(double{a.mean(x, y)[c]} - b.mean(x, y)[c]);
        const Estimate difference = estimate(differences);
        EXPECT_GE(statistical::normalTail(difference.mean / (difference.error + 1e-30)),
                  statistical::kAlpha)
            << "channel " << c << ": " << difference.mean << " +- " << difference.error << " of "
            << channelMean(a, c).mean;
    }
}

} // namespace wellstrat::render
