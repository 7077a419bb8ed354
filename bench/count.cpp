// SPDX-License-Identifier: Apache-2.0

#include "count.h"

#include "scenarios.h"
#include "wellstrat/joint.h"

#include <cstdio>
#include <cstring>

namespace wellstrat {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

struct Arrays {
    std::vector<SampleCtx> contexts, children;
    std::vector<RtFloat2> xis;
    std::vector<RtFloat3> points;
};

template <unsigned kDepth>
void derive(Arrays& a) {
    for (std::size_t first = 0; first + kDepth <= a.xis.size(); first += kDepth) {
        SampleCtx sc = a.contexts[first];
        for (unsigned k = 0; k < kDepth; ++k) {
            sc = sc.NewDomain(kScramble);
            a.xis[first + k] = sample2D(sc.patternid, sc.sampleid);
        }
    }
}

RixRNG rngOf(Arrays& a, const Generator* generator = nullptr) {
    return RixRNG(a.contexts.data(), static_cast<unsigned>(a.contexts.size()), generator);
}

struct Path {
    const char* name;
    void (*draw)(Arrays& arrays);
};

const Path kPaths[] = {
    {"nothing", [](Arrays&) {}},
    {"scalar",
     [](Arrays& a) {
         const RixRNG rng = rngOf(a);
         for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
     }},
    {"scalar-3D",
     [](Arrays& a) {
         const RixRNG rng = rngOf(a);
         for (unsigned i = 0; i < rng.numPts; ++i) a.points[i] = rng.DrawSample3D(i);
     }},
    {"path-of-8", derive<8>},
    {"chain", derive<16>},
    {"few-points",
     [](Arrays& a) { // RixRNGs of one point
         for (std::size_t i = 0; i < a.contexts.size(); ++i) {
             const RixRNG child(RixRNG(&a.contexts[i], 1), kScramble, &a.children[i]);
             child.DrawSamples2D(&a.xis[i]);
         }
     }},
    {"joint",
     [](Arrays& a) { // with what deriving the slot takes, in one batch
         static const JointProgressive joint;
         const RixRNG rng(rngOf(a, &joint), jointScramble(1), a.children.data());
         for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
     }},
    {"batch", [](Arrays& a) { rngOf(a).DrawSamples2D(a.xis.data()); }},
};

} // namespace

bool drawForCounting(const char* path, unsigned samples) {
    for (const Path& known : kPaths) {
        if (std::strcmp(known.name, path) != 0) continue;
        Arrays a{std::vector<SampleCtx>(samples), std::vector<SampleCtx>(samples),
                 std::vector<RtFloat2>(samples), std::vector<RtFloat3>(samples)};
        for (unsigned i = 0; i < samples; ++i) a.contexts[i] = {HashToUnsigned(1, i), 7};
        known.draw(a);
        benchmark::DoNotOptimize(a.xis.data());
        benchmark::DoNotOptimize(a.points.data());
        return true;
    }
    std::fputs("wellstrat_bench: --count takes one of", stderr);
    for (const Path& known : kPaths) std::fprintf(stderr, " %s", known.name);
    std::fputs("\n", stderr);
    return false;
}

} // namespace wellstrat
