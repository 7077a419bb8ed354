// SPDX-License-Identifier: Apache-2.0
//
// Batches of draws and of new domains, on each target.

#include "scenarios.h"
#include "wellstrat/c.h"

namespace wellstrat {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

/// kDrawAll2D by the interface in C.
constexpr auto kDrawAll2DInC = +[](const RixRNG& rng, RtFloat2* xis) {
    const wellstrat_domain domain = {WELLSTRAT_PMJ, WELLSTRAT_NO_SLOT, 1};
    const auto* contexts = reinterpret_cast<const wellstrat_context*>(rng.sampleCtxArray);
    wellstrat_draw_samples_2d(domain, rng.numPts, contexts, &xis->x);
};

template <typename DrawAll>
void addDraws(const std::string& name, const std::vector<int64_t>& sizes, Access access,
              DrawAll draw) {
    addBatches(name, sizes, [=](benchmark::State& state, Caches caches) {
        const auto n = static_cast<std::size_t>(state.range(0));
        std::vector<SampleCtx> contexts = makeContexts(n, access);
        const RixRNG rng(contexts.data(), static_cast<unsigned>(n));
        drawAll(state, caches, contexts, access, rng, draw);
    });
}

/// What coherent draws with warm caches spend on stepping the contexts, to be subtracted by the
/// reader.
void step(benchmark::State& state) {
    std::vector<SampleCtx> contexts =
        makeContexts(static_cast<std::size_t>(state.range(0)), Access::coherent);
    runRounds(state, Caches::warm, contexts, Access::coherent, contexts.size(), [] {});
}

// New domains are made from contexts that stay, of which random ones are an example.

void derive(benchmark::State& state, Caches caches) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> parents = makeContexts(n, Access::random);
    std::vector<SampleCtx> children(n);
    const RixRNG rng(parents.data(), static_cast<unsigned>(n));
    runRounds(state, caches, parents, Access::random, n,
              [&] { rng.NewDomains(kScramble, children.data()); });
}

void deriveThenDraw(benchmark::State& state, Caches caches) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> parents = makeContexts(n, Access::coherent);
    std::vector<SampleCtx> children(n);
    std::vector<RtFloat2> xis(n);
    const RixRNG camera(parents.data(), static_cast<unsigned>(n));
    runRounds(state, caches, parents, Access::coherent, n, [&] {
        const RixRNG bxdf(camera, kScramble, children.data());
        bxdf.DrawSamples2D(xis.data());
    });
}

void hashes(benchmark::State& state, Caches caches) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> contexts = makeContexts(n, Access::random);
    std::vector<float> xis(n);
    runRounds(state, caches, contexts, Access::random, n,
              [&] { hashToRandom(n, contexts.data(), xis.data()); });
}

const Suite kSuite([] {
    const std::vector<int64_t> sizes = {16, 256, 4096, 65536};
    benchmark::RegisterBenchmark("step contexts", step)->Arg(4096);
    addDraws("coherent 1D", sizes, Access::coherent, kDrawAll1D);
    addDraws("coherent 2D", sizes, Access::coherent, kDrawAll2D);
    addDraws("coherent 3D", sizes, Access::coherent, kDrawAll3D);
    addDraws("random 1D", sizes, Access::random, kDrawAll1D);
    addDraws("random 2D", sizes, Access::random, kDrawAll2D);
    addDraws("random 3D", sizes, Access::random, kDrawAll3D);
    addDraws("one pattern 2D", {4096}, Access::onePattern, kDrawAll2D);
    addDraws("in C, coherent 2D", sizes, Access::coherent, kDrawAll2DInC);
    addBatches("new domains", {4096}, derive);
    addBatches("new domains, draw 2D", {4096}, deriveThenDraw);
    addBatches("hash to random", {4096}, hashes);
});

} // namespace
} // namespace wellstrat
