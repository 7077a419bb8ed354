// SPDX-License-Identifier: Apache-2.0
//
// Inline lookups, compiled with the user's flags, give the same bits as the library's compiled
// batch functions, which have the library's flags. (That those are the right bits, the golden tests
// say.) Guards against floating point in the headers that -ffast-math or a newer C++ could change.

#include "all_headers.h"

#include "app.h"

#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr unsigned kPoints = 100000;

template <typename T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

int fail(const char* what, unsigned i) {
    std::fprintf(stderr, "%s differs at point %u\n", what, i);
    return 1;
}

} // namespace

int main() {
    std::vector<RixRNG::SampleCtx> contexts(kPoints);
    for (unsigned i = 0; i < kPoints; ++i) {
        // Sampleids up to and past the last stratified one.
        contexts[i] = wellstrat::cameraContext(static_cast<int>(i % 512), static_cast<int>(i / 512),
                                               7, i * 2);
    }
    const RixRNG rng(contexts.data(), kPoints);
    std::vector<float> xi1(kPoints);
    std::vector<RtFloat2> xi2(kPoints);
    std::vector<RtFloat3> xi3(kPoints);
    std::vector<float> random(kPoints);
    std::vector<RixRNG::SampleCtx> children(kPoints);
    const auto scramble = static_cast<RixRNG::Scramble>(0x5eed1234u);
    rng.DrawSamples1D(xi1.data());
    rng.DrawSamples2D(xi2.data());
    rng.DrawSamples3D(xi3.data());
    rng.NewDomainsSplit(scramble, 4, children.data());
    wellstrat::hashToRandom(kPoints, contexts.data(), random.data());

    for (unsigned i = 0; i < kPoints; ++i) {
        const RixRNG::SampleCtx sc = contexts[i];
        if (!sameBits(rng.DrawSample1D(i), xi1[i])) return fail("DrawSample1D", i);
        if (!sameBits(rng.DrawSample2D(i), xi2[i])) return fail("DrawSample2D", i);
        if (!sameBits(rng.DrawSample3D(i), xi3[i])) return fail("DrawSample3D", i);
        if (!sameBits(drawInSecondUnit(sc.patternid, sc.sampleid), xi3[i])) {
            return fail("DrawSample3D in the second unit", i);
        }
        if (!sameBits(rng.NewDomainSplit(i, scramble, 4), children[i])) {
            return fail("NewDomainSplit", i);
        }
        if (!sameBits(HashToRandom(sc.patternid, sc.sampleid), random[i])) {
            return fail("HashToRandom", i);
        }
    }
    std::printf("wellstrat %s, stream version %u: %u points agree\n", WELLSTRAT_VERSION_STRING,
                wellstrat::kStreamVersion, kPoints);
    return 0;
}
