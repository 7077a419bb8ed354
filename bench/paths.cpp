// SPDX-License-Identifier: Apache-2.0
//
// What integrators do for one path, or for the few points that are left of a batch: derive domains
// and draw from them at once.

#include "scenarios.h"

namespace wellstrat {
namespace {

constexpr std::size_t kDraws = 1024; ///< in a round with cluttered caches
constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

/// Derives a domain from the last one and draws from it, kDepth times, for one path after the
/// other.
template <unsigned kDepth>
void tracePaths(benchmark::State& state, Caches caches, Access access) {
    const std::size_t paths = caches == Caches::warm ? kDraws : kDraws / kDepth;
    std::vector<SampleCtx> contexts = makeContexts(paths, access);
    RtFloat2 xis[kDepth];
    runRounds(state, caches, contexts, access, paths * kDepth, [&] {
        for (SampleCtx sc : contexts) {
            for (RtFloat2& xi : xis) {
                sc = sc.NewDomain(kScramble);
                xi = sample2D(sc.patternid, sc.sampleid);
            }
            benchmark::DoNotOptimize(xis);
        }
    });
}

template <unsigned kDepth>
void addPaths(const std::string& name, Access access) {
    addScenario(name, {}, [access](benchmark::State& state, Caches caches) {
        tracePaths<kDepth>(state, caches, access);
    });
}

/// Calls drawOne(parent, contexts, xis) for RixRNGs of few points, as many as state.range(0) says.
template <typename DrawOne>
void drawFew(benchmark::State& state, Caches caches, DrawOne drawOne) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> parents = makeContexts(kDraws, Access::coherent);
    std::vector<SampleCtx> children(n);
    std::vector<RtFloat2> xis(n);
    benchmark::DoNotOptimize(children.data());
    benchmark::DoNotOptimize(xis.data());
    runRounds(state, caches, parents, Access::coherent, kDraws, [&] {
        for (std::size_t first = 0; first + n <= kDraws; first += n) {
            const RixRNG parent(&parents[first], static_cast<unsigned>(n));
            drawOne(parent, children.data(), xis.data());
            benchmark::ClobberMemory();
        }
    });
}

void drawFewByConstructor(benchmark::State& state, Caches caches) {
    drawFew(state, caches, [](const RixRNG& parent, SampleCtx* children, RtFloat2* xis) {
        const RixRNG child(parent, kScramble, children);
        child.DrawSamples2D(xis);
    });
}

void drawFewInlined(benchmark::State& state, Caches caches) {
    drawFew(state, caches, [](const RixRNG& parent, SampleCtx* children, RtFloat2* xis) {
        for (unsigned i = 0; i < parent.numPts; ++i) {
            children[i] = parent.NewDomain(i, kScramble);
            xis[i] = sample2D(children[i].patternid, children[i].sampleid);
        }
    });
}

const Suite kSuite([] {
    addPaths<8>("derive-and-draw path of 8", Access::coherent);
    addPaths<8>("derive-and-draw path of 8, random sampleids", Access::random);
    addPaths<16>("scalar new domain, draw 2D, chain of 16", Access::coherent);
    addPaths<16>("scalar new domain, draw 2D, chain of 16, random sampleids", Access::random);
    addScenario("few points, constructor and batch", {1, 2, 4, 8}, drawFewByConstructor);
    addScenario("few points, inlined calls", {1, 2, 4, 8}, drawFewInlined);
});

} // namespace
} // namespace wellstrat
