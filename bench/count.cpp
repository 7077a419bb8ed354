// SPDX-License-Identifier: Apache-2.0

#include "count.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <utility>

namespace wellstrat {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

using Path = std::pair<const char*, void (*)(CountedArrays&)>;

std::vector<Path>& paths() {
    static std::vector<Path> all;
    return all;
}

template <unsigned kDepth>
void derive(CountedArrays& a) {
    for (std::size_t first = 0; first + kDepth <= a.xis.size(); first += kDepth) {
        SampleCtx sc = a.contexts[first];
        for (unsigned k = 0; k < kDepth; ++k) {
            sc = sc.NewDomain(kScramble);
            a.xis[first + k] = sample2D(sc.patternid, sc.sampleid);
        }
    }
}

void drawScalar2D(CountedArrays& a) {
    const RixRNG rng = a.rng();
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
}

void drawScalar3D(CountedArrays& a) {
    const RixRNG rng = a.rng();
    for (unsigned i = 0; i < rng.numPts; ++i) a.points[i] = rng.DrawSample3D(i);
}

/// RixRNGs of one point.
void drawFew(CountedArrays& a) {
    for (std::size_t i = 0; i < a.contexts.size(); ++i) {
        const RixRNG child(RixRNG(&a.contexts[i], 1), kScramble, &a.children[i]);
        child.DrawSamples2D(&a.xis[i]);
    }
}

const CountedPath kPaths[] = {
    {"nothing", [](CountedArrays&) {}},
    {"scalar", drawScalar2D},
    {"scalar-3D", drawScalar3D},
    {"path-of-8", derive<8>},
    {"chain", derive<16>},
    {"few-points", drawFew},
    {"batch", [](CountedArrays& a) { a.rng().DrawSamples2D(a.xis.data()); }},
};

} // namespace

CountedPath::CountedPath(const char* name, void (*draw)(CountedArrays& arrays)) {
    paths().emplace_back(name, draw);
}

bool drawForCounting(const char* path, unsigned samples) {
    for (const auto& [name, draw] : paths()) {
        if (std::strcmp(name, path) != 0) continue;
        CountedArrays a{std::vector<SampleCtx>(samples), std::vector<SampleCtx>(samples),
                        std::vector<RtFloat2>(samples), std::vector<RtFloat3>(samples)};
        for (unsigned i = 0; i < samples; ++i) a.contexts[i] = {HashToUnsigned(1, i), 7};
        draw(a);
        benchmark::DoNotOptimize(a.xis.data());
        benchmark::DoNotOptimize(a.points.data());
        return true;
    }
    std::fputs("wellstrat_bench: --count takes one of", stderr);
    for (const Path& known : paths()) std::fprintf(stderr, " %s", known.first);
    std::fputs("\n", stderr);
    return false;
}

} // namespace wellstrat
