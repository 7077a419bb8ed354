// SPDX-License-Identifier: Apache-2.0
//
// The slots of a path share their order among all pixels, so that the errors of pixels must be
// independent by their tables, axes and digital shifts alone. Errors of products over two slots are
// correlated between pixels, frames, and pairs of slots; and no pixel may be biased.
//
// False alarms: statistics.h; 3 checks for each of 8 cases.

#include "RixRNG.h"
#include "statistical/statistics.h"
#include "wellstrat/camera.h"
#include "wellstrat/joint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace statistical;
using namespace wellstrat;

constexpr int kWidth = 256, kHeight = 128;

/// Whether the point lies in a disk of area 1/2, which no symmetry of the square makes its own
/// complement.
bool inDisk(Float2 p) { return p.x * p.x + p.y * p.y < 2 / 3.14159265f; }

/// The errors of the pixels of a frame, row by row, with `count` samples of a disk in `first` times
/// a disk in `second`.
std::vector<double> errors(unsigned frame, unsigned count, unsigned first, unsigned second) {
    const JointProgressive joint;
    const unsigned n = kWidth * kHeight;
    std::vector<SampleCtx> camera(n), a(n), b(n);
    std::vector<Float2> xiA(n), xiB(n);
    std::vector<double> sums(n, 0.0);
    for (unsigned sample = 0; sample < count; ++sample) {
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                camera[static_cast<std::size_t>(y * kWidth + x)] =
                    cameraContext(x, y, frame, sample);
            }
        }
        const RixRNG rng(camera.data(), n, &joint);
        RixRNG(rng, jointScramble(first), a.data()).DrawSamples2D(xiA.data());
        RixRNG(rng, jointScramble(second), b.data()).DrawSamples2D(xiB.data());
        for (unsigned i = 0; i < n; ++i) sums[i] += inDisk(xiA[i]) && inDisk(xiB[i]) ? 1.0 : 0.0;
    }
    for (double& sum : sums) sum = sum / count - 0.25;
    return sums;
}

double meanProduct(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum / static_cast<double>(a.size());
}

/// The correlation of two fields of errors in units of its standard deviation.
double score(const std::vector<double>& a, const std::vector<double>& b) {
    return meanProduct(a, b) / std::sqrt(meanProduct(a, a) * meanProduct(b, b)) *
           std::sqrt(static_cast<double>(a.size()));
}

class JointPixels : public testing::TestWithParam<unsigned> {};

TEST_P(JointPixels, ErrorsAreIndependent) {
    const unsigned count = GetParam();
    const auto check = [](double z, const char* what) {
        EXPECT_GE(normalTail(z), kAlpha) << what << ": " << z << " standard deviations";
    };
    for (const auto& [first, second] : {std::pair(0u, 1u), std::pair(6u, 15u)}) {
        const std::vector<double> here = errors(0, count, first, second);
        std::vector<double> left(here.begin(), here.end() - 1), right(here.begin() + 1, here.end());
        check(score(left, right), "neighbors");
        check(score(here, errors(1, count, first, second)), "frames");
        double sum = 0;
        for (const double error : here) sum += error;
        check(sum / std::sqrt(meanProduct(here, here) * static_cast<double>(here.size())), "bias");
    }
}

INSTANTIATE_TEST_SUITE_P(Counts, JointPixels, testing::Values(1u, 4u, 16u, 64u));

} // namespace
