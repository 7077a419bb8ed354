// SPDX-License-Identifier: Apache-2.0
//
// How to find an integrator's mistakes with domains. This one has two; the pictures that it makes
// would only be noisier than they should be.

#include <RixRNG.h>
#include <wellstrat/camera.h>
#include <wellstrat/domain_linter.h>

#include <cstdio>

constexpr unsigned kPixels = 16, kSamples = 4;
constexpr RixRNG::Scramble kHit{0x03707344}, kLight{0xa4093822}, kBxdf{0x082efa98};

/// Traces one path through each of `kPixels` pixels, to two hits.
static void trace(unsigned sampleid, const RixRNG::Generator* generator) {
    RixRNG::SampleCtx contexts[kPixels], domain[kPixels];
    for (unsigned i = 0; i < kPixels; ++i) {
        contexts[i] = wellstrat::cameraContext(static_cast<int>(i), 0, 0, sampleid);
    }
    RixRNG rng(contexts, kPixels, generator);
    RtFloat2 xi[kPixels];
    RixRNG(rng, wellstrat::kPixelFilterScramble, domain).DrawSamples2D(xi);
    for (unsigned bounce = 0; bounce < 2; ++bounce) {
        rng = RixRNG(rng, kHit, contexts);
        RixRNG light(rng, kLight, domain, RixRNG::Split{4});
        for (unsigned k = 0; k < 3; ++k) light.GenerateSamples2D(xi); // one less than it said
        const RixRNG bxdf(rng, kBxdf, domain);
        bxdf.DrawSamples2D(xi);                  // which direction
        if (bounce == 0) bxdf.DrawSamples2D(xi); // does the path end? by the same sample
    }
}

int main() {
    const wellstrat::DomainLinter linter; // passes on the tables' samples
    for (unsigned s = 0; s < kSamples; ++s) trace(s, &linter);
    std::fputs(linter.report().c_str(), stdout);
}
