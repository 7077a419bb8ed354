// SPDX-License-Identifier: Apache-2.0
//
// Frames of blue pixels, as an average over time and a filter over pixels show them. A camera that
// stands still sees integrands that vary slowly from pixel to pixel, one sample of each pixel a
// frame; what is seen is the exponential average of the frames after a Gaussian of 2 pixels. Frames
// whose sampleids go on are stratified in time and over pixels at once.
//
// False alarms: a ratio is a geometric mean over six integrands in 8 pictures. In 20 other sets of
// 8 it had standard deviations of 0.9 to 1.3 %, with gaps 2.3 %; each limit is six of these away
// from its mean, so the chance of any false alarm is below 10^-7.

#include "RixRNG.h"
#include "wellstrat/analysis/picture_error.h"
#include "wellstrat/blue.h"
#include "wellstrat/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace wellstrat::test {
namespace {

constexpr unsigned kSize = 76, kPixels = kSize * kSize;
constexpr unsigned kPictures = 8, kFrames = 80, kFirstSeen = 40;
constexpr double kNewest = 0.1; // the weight of the newest frame

const BlueProgressive kBlue;

/// Where the one sample of a pixel is, in each frame.
enum class Rule { goingOn, independent, withGaps };

struct Sampling {
    const Generator* generator; ///< null: the tables
    bool slots;                 ///< of domains
    Rule rule;
};

/// The contexts of all pixels in a frame of a picture.
std::vector<SampleCtx> frameContexts(const Sampling& sampling, unsigned picture, unsigned frame) {
    const bool anew = sampling.rule == Rule::independent;
    const unsigned seed = anew ? picture * kFrames + frame : picture;
    const unsigned sampleid = anew ? 0 : sampling.rule == Rule::goingOn ? frame : 2 * frame;
    std::vector<SampleCtx> contexts;
    for (unsigned p = 0; p < kPixels; ++p) {
        const auto x = static_cast<int>(p % kSize), y = static_cast<int>(p / kSize);
        contexts.push_back(sampling.generator
                               ? sampling.generator->CameraContext(x, y, seed, sampleid)
                               : cameraContext(x, y, 0, sampleid, seed));
    }
    return contexts;
}

/// The root of the mean squared error of the filtered averages.
double errorOf(const Sampling& sampling, const IntegrandPicture& integrand) {
    static const GaussianFilter filter(2);
    const auto domains = static_cast<unsigned>(integrand.domains.size());
    std::vector<std::vector<Float2>> xis(domains, std::vector<Float2>(kPixels));
    std::vector<double> point(2 * std::size_t{domains});
    double squares = 0;
    for (unsigned picture = 0; picture < kPictures; ++picture) {
        std::vector<double> average(kPixels, 0.0);
        for (unsigned frame = 0; frame < kFrames; ++frame) {
            std::vector<SampleCtx> contexts = frameContexts(sampling, picture, frame);
            std::vector<SampleCtx> children(kPixels);
            const RixRNG camera(contexts, kPixels, sampling.generator);
            for (unsigned d = 0; d < domains; ++d) {
                const Scramble padded{0x2d96c92bu + d};
                RixRNG(camera, sampling.slots ? jointScramble(d) : padded, children)
                    .DrawSamples2D(xis[d]);
            }
            for (unsigned p = 0; p < kPixels; ++p) {
                for (unsigned d = 0; d < domains; ++d) {
                    point[2 * d] = double{xis[d][p].x};
                    point[2 * d + 1] = double{xis[d][p].y};
                }
                const Integrand& f = integrand.pixels[p];
                average[p] += kNewest * (f.value(point.data()) - f.integral - average[p]);
            }
            if (frame < kFirstSeen) continue;
            for (const double error : filter.apply(average, kSize)) squares += error * error;
        }
    }
    return std::sqrt(squares);
}

/// The geometric mean of the errors relative to those of independent frames of white pixels.
double ratioToWhite(const Sampling& sampling) {
    static const std::vector<std::string> names{"edge",   "gaussian",   "smooth",
                                                "edge^2", "gaussian^2", "smooth^2"};
    double product = 1;
    for (const std::string& name : names) {
        const IntegrandPicture integrand = makeIntegrandPicture(name, kSize);
        product *=
            errorOf(sampling, integrand) / errorOf({nullptr, false, Rule::independent}, integrand);
    }
    return std::pow(product, 1.0 / static_cast<double>(names.size()));
}

TEST(BlueFrames, ThatGoOnAreBlueInTimeAndOverPixels) {
    EXPECT_LT(ratioToWhite({&kBlue, false, Rule::goingOn}), 0.353); // 0.327
    EXPECT_LT(ratioToWhite({&kBlue, true, Rule::goingOn}), 0.277);  // 0.265
}

TEST(BlueFrames, NeedBothAndNoGaps) {
    EXPECT_GT(ratioToWhite({nullptr, false, Rule::goingOn}), 0.56); // white pixels: 0.585
    EXPECT_GT(ratioToWhite({&kBlue, true, Rule::withGaps}), 0.44);  // 0.606
}

} // namespace
} // namespace wellstrat::test
