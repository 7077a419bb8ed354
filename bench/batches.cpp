// SPDX-License-Identifier: Apache-2.0
//
// Batches of draws and of new domains, on each target.

#include "domains.h"

namespace wellstrat {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

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
    const MakeDomain tables = cameraDomain();
    benchmark::RegisterBenchmark("step contexts", step)->Arg(4096);
    addBatch("coherent 1D", sizes, Access::coherent, tables, kDrawAll1D);
    addBatch("coherent 2D", sizes, Access::coherent, tables, kDrawAll2D);
    addBatch("coherent 3D", sizes, Access::coherent, tables, kDrawAll3D);
    addBatch("random 1D", sizes, Access::random, tables, kDrawAll1D);
    addBatch("random 2D", sizes, Access::random, tables, kDrawAll2D);
    addBatch("random 3D", sizes, Access::random, tables, kDrawAll3D);
    addBatch("one pattern 2D", {4096}, Access::onePattern, tables, kDrawAll2D);
    addBatches("new domains", {256, 4096}, derive);
    addBatches("new domains, draw 2D", {4096}, deriveThenDraw);
    addBatches("hash to random", {4096}, hashes);
});

} // namespace
} // namespace wellstrat
