// SPDX-License-Identifier: Apache-2.0
//
// How an integrator shades the points of a batch that hit different materials. Each material gets
// a RixRNG of its own points, derived by their indices, which keeps what slots of a
// JointProgressive have to give: the choice of the material, by the pixel, and the direction that
// it reflects to are stratified together.

#include <RixRNG.h>
#include <wellstrat/camera.h>
#include <wellstrat/joint.h>

#include <cmath>
#include <cstdio>
#include <vector>

/// Whether a direction of each material reaches the lamp: of metal half, of cloth a triangle.
static bool metalIsLit(RtFloat2 xi) { return xi.x < 0.5f; }
static bool clothIsLit(RtFloat2 xi) { return xi.x + xi.y < 0.5f; }

/// How many of the hits in `points` are lit. All draw from slot 1; each path does so once, since a
/// point has one material.
static unsigned lit(const RixRNG& hits, const std::vector<unsigned>& points,
                    bool (*isLit)(RtFloat2)) {
    const auto n = static_cast<unsigned>(points.size());
    std::vector<RixRNG::SampleCtx> contexts(n);
    const RixRNG direction(hits, wellstrat::jointScramble(1), points, n, contexts);
    std::vector<RtFloat2> xi(n);
    direction.DrawSamples2D(xi);
    unsigned sum = 0;
    for (const RtFloat2 p : xi) sum += isLit(p);
    return sum;
}

/// The brightness of pixel x, half metal and half cloth with a slanted edge between them.
static double brightness(int x, unsigned count, const RixRNG::Generator* generator) {
    std::vector<RixRNG::SampleCtx> contexts(count), inPixel(count);
    for (unsigned i = 0; i < count; ++i) contexts[i] = wellstrat::cameraContext(x, 0, 0, i);
    const RixRNG camera(contexts, count, generator);
    const RixRNG pixel(camera, wellstrat::jointScramble(0), inPixel);
    std::vector<RtFloat2> xi(count);
    pixel.DrawSamples2D(xi);
    std::vector<unsigned> metal, cloth;
    for (unsigned i = 0; i < count; ++i) {
        (2 * xi[i].x + xi[i].y < 1.5f ? metal : cloth).push_back(i);
    }
    return static_cast<double>(lit(camera, metal, metalIsLit) + lit(camera, cloth, clothIsLit)) /
           count;
}

/// The root of the mean squared error over 500 pixels.
static double error(unsigned count, const RixRNG::Generator* generator) {
    constexpr int kPixels = 500;
    constexpr double kExact = 0.5 * 0.5 + 0.5 * 0.125;
    double sum = 0.0;
    for (int x = 0; x < kPixels; ++x) sum += std::pow(brightness(x, count, generator) - kExact, 2);
    return std::sqrt(sum / kPixels);
}

int main() {
    const wellstrat::JointProgressive joint;
    std::printf("RMSE of a pixel with two materials, over 500 pixels\n\n");
    std::printf("samples    padded     joint   ratio\n");
    for (unsigned count = 16; count <= 4096; count *= 4) {
        const double padded = error(count, nullptr);
        const double together = error(count, &joint);
        std::printf("%7u %9.5f %9.5f %7.2f\n", count, padded, together, together / padded);
    }
}
