// SPDX-License-Identifier: Apache-2.0
//
// A generator in place of the tables: every sample from drand48(). For experiments only, as its
// samples depend on the order of the calls.

#include "RixRNG.h"
#include "check.h"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

class RandomSampler : public RixRNG::Generator {
public:
    float Sample1D(const RixRNG::SampleCtx& /*sc*/, unsigned /*i*/) const override {
        return next();
    }
    RtFloat2 Sample2D(const RixRNG::SampleCtx& /*sc*/, unsigned /*i*/) const override {
        const float x = next();
        return RtFloat2(x, next());
    }
    RtFloat3 Sample3D(const RixRNG::SampleCtx& /*sc*/, unsigned /*i*/) const override {
        const float x = next();
        const float y = next();
        return RtFloat3(x, y, next());
    }
    void MultiSample1D(unsigned n, const RixRNG::SampleCtx& /*sc*/, float* xis) const override {
        for (unsigned i = 0; i < n; i++) xis[i] = next();
        ++multiCalls;
    }
    void MultiSample2D(unsigned n, const RixRNG::SampleCtx& sc, RtFloat2* xis) const override {
        for (unsigned i = 0; i < n; i++) xis[i] = Sample2D(sc, i);
        ++multiCalls;
    }
    void MultiSample3D(unsigned n, const RixRNG::SampleCtx& sc, RtFloat3* xis) const override {
        for (unsigned i = 0; i < n; i++) xis[i] = Sample3D(sc, i);
        ++multiCalls;
    }

    mutable int multiCalls = 0;

private:
    /// drand48 has 48 bits, so the largest values round to 1.0f.
    static float next() {
        const float x = static_cast<float>(drand48());
        return x < 1.0f ? x : x - 1.0f;
    }
};

bool inUnit(float x) { return x >= 0.0f && x < 1.0f; }

} // namespace

int main() {
    srand48(2024);
    const RandomSampler sampler;
    const unsigned numPts = 4096;
    std::vector<RixRNG::SampleCtx> contexts(numPts, {1, 0}), childContexts(numPts);
    RixRNG rng(contexts.data(), numPts, &sampler);

    // Children inherit the generator, however they are made.
    const RixRNG::Scramble scramble = static_cast<RixRNG::Scramble>(0x9d39247e);
    RixRNG child(rng, scramble, childContexts.data());
    CHECK(child.generator == &sampler);
    CHECK(RixRNG(&rng, childContexts.data(), numPts).generator == &sampler);
    CHECK(RixRNG(rng, scramble, childContexts.data(), RixRNG::Split{4}).generator == &sampler);
    CHECK(RixRNG(rng, scramble, childContexts.data(), RixRNG::Distrib{0}).generator == &sampler);

    std::vector<float> x(numPts);
    std::vector<RtFloat2> xy(numPts);
    std::vector<RtFloat3> xyz(numPts);
    child.DrawSamples1D(x.data());
    child.DrawSamples2D(xy.data());
    child.DrawSamples3D(xyz.data());
    CHECK(sampler.multiCalls == 3);

    // Means of 4096 independent values; 0.03 is more than six standard deviations.
    double sums[6] = {};
    bool inside = true;
    for (unsigned i = 0; i < numPts; i++) {
        const float values[6] = {x[i], xy[i].x, xy[i].y, xyz[i].x, xyz[i].y, xyz[i].z};
        for (int k = 0; k < 6; k++) {
            inside = inside && inUnit(values[k]);
            sums[k] += values[k];
        }
    }
    CHECK(inside);
    for (const double sum : sums) CHECK(std::fabs(sum / numPts - 0.5) < 0.03);

    // Equal contexts, but no two draws are equal: the generator, and not the tables, was asked.
    CHECK(child.DrawSample1D(0) != child.DrawSample1D(0));
    CHECK(child.DrawSample2D(0) != child.DrawSample2D(0));
    CHECK(child.GenerateSample3D(0) != child.GenerateSample3D(0));
    CHECK(sampler.multiCalls == 3);
    return exitCode();
}
