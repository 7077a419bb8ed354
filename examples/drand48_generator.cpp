// SPDX-License-Identifier: Apache-2.0
//
// How to replace the samples of a RixRNG: a Generator over drand48(), and what it costs. The same
// integrator code runs with both; only the pointer that the RixRNG is made with differs.

#include <RixRNG.h>
#include <wellstrat/camera.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

/// Samples of drand48(), for debugging. It ignores the context, so a DrawSample call repeated gives
/// another value, and its one hidden state is not safe in several threads: use
/// wellstrat::RandomGenerator where that matters. The functions for many points are inherited;
/// override them where a batch can be made faster than one by one.
class Drand48Generator final : public RixRNG::Generator {
public:
    float Sample1D(const RixRNG::SampleCtx& /*sc*/, unsigned /*i*/) const override {
        return next();
    }
    RtFloat2 Sample2D(const RixRNG::SampleCtx& /*sc*/, unsigned /*i*/) const override {
        const float x = next();
        return {x, next()};
    }
    RtFloat3 Sample3D(const RixRNG::SampleCtx& /*sc*/, unsigned /*i*/) const override {
        const float x = next();
        const float y = next();
        return {x, y, next()};
    }

private:
    /// A multiple of 2^-24 below 1. A plain conversion of the double could round up to 1.
    static float next() { return static_cast<float>(std::floor(drand48() * 0x1p24)) * 0x1p-24f; }
};

/// Estimates the area of a quarter disk, pi / 4, in pixel x with `count` samples.
static double quarterDisk(int x, unsigned count, const RixRNG::Generator* generator) {
    std::vector<RixRNG::SampleCtx> contexts(count);
    for (unsigned i = 0; i < count; ++i) contexts[i] = wellstrat::cameraContext(x, 0, 0, i);
    const RixRNG rng(contexts.data(), count, generator);
    std::vector<RtFloat2> xi(count);
    rng.DrawSamples2D(xi.data());
    unsigned inside = 0;
    for (const RtFloat2 p : xi) inside += p.x * p.x + p.y * p.y < 1.0f;
    return static_cast<double>(inside) / count;
}

/// The root of the mean squared error over 500 pixels.
static double error(unsigned count, const RixRNG::Generator* generator) {
    constexpr int kPixels = 500;
    const double exact = std::acos(-1.0) / 4.0;
    double sum = 0.0;
    for (int x = 0; x < kPixels; ++x) {
        sum += std::pow(quarterDisk(x, count, generator) - exact, 2);
    }
    return std::sqrt(sum / kPixels);
}

int main() {
    srand48(1);
    const Drand48Generator drand48Generator;
    std::printf("RMSE of the area of a quarter disk, over 500 pixels\n\n");
    std::printf("samples   drand48    tables   ratio\n");
    for (unsigned count = 4; count <= 4096; count *= 4) {
        const double random = error(count, &drand48Generator);
        const double tables = error(count, nullptr);
        std::printf("%7u %9.5f %9.5f %7.2f\n", count, random, tables, tables / random);
    }
}
