// SPDX-License-Identifier: Apache-2.0
//
// Batches of draws and of new domains, on each target.

#include "batches.h"

#include "contexts.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/joint.h"

#include <string>

namespace wellstrat {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

/// Draws of a whole RixRNG. The contexts are as the access says, and coherent ones step on by one
/// sample with each iteration, as a progressive renderer does.
template <typename Sample>
void draw(benchmark::State& state, Access access, void (RixRNG::*function)(Sample*) const,
          const Generator* generator = nullptr) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> contexts = makeContexts(n, access);
    std::vector<Sample> xis(n);
    const RixRNG rng(contexts.data(), static_cast<unsigned>(n), generator);
    for (auto _ : state) {
        if (access == Access::coherent) {
            for (SampleCtx& sc : contexts) sc.sampleid = (sc.sampleid + 1) % 4096;
        }
        (rng.*function)(xis.data());
        benchmark::ClobberMemory();
    }
    reportItems(state, n);
}

/// What `draw` spends on stepping the contexts, to be subtracted by the reader.
void stepContexts(benchmark::State& state) {
    std::vector<SampleCtx> contexts =
        makeContexts(static_cast<std::size_t>(state.range(0)), Access::coherent);
    for (auto _ : state) {
        for (SampleCtx& sc : contexts) sc.sampleid = (sc.sampleid + 1) % 4096;
        benchmark::ClobberMemory();
    }
    reportItems(state, contexts.size());
}

void derive(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> parents = makeContexts(n, Access::coherent);
    std::vector<SampleCtx> children(n);
    const RixRNG rng(parents.data(), static_cast<unsigned>(n));
    for (auto _ : state) {
        rng.NewDomains(kScramble, children.data());
        benchmark::ClobberMemory();
    }
    reportItems(state, n);
}

void deriveThenDraw(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> parents = makeContexts(n, Access::coherent);
    std::vector<SampleCtx> children(n);
    std::vector<RtFloat2> xis(n);
    const RixRNG camera(parents.data(), static_cast<unsigned>(n));
    for (auto _ : state) {
        const RixRNG bxdf(camera, kScramble, children.data());
        bxdf.DrawSamples2D(xis.data());
        benchmark::ClobberMemory();
    }
    reportItems(state, n);
}

void hashes(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0));
    const std::vector<SampleCtx> contexts = makeContexts(n, Access::random);
    std::vector<float> xis(n);
    for (auto _ : state) {
        hashToRandom(n, contexts.data(), xis.data());
        benchmark::ClobberMemory();
    }
    reportItems(state, n);
}

} // namespace

void registerBatches() {
    using benchmark::RegisterBenchmark;
    constexpr auto draw1D = static_cast<void (RixRNG::*)(float*) const>(&RixRNG::DrawSamples1D);
    constexpr auto draw2D = static_cast<void (RixRNG::*)(RtFloat2*) const>(&RixRNG::DrawSamples2D);
    constexpr auto draw3D = static_cast<void (RixRNG::*)(RtFloat3*) const>(&RixRNG::DrawSamples3D);

    const Generator* slot = JointProgressive().ForChild(jointScramble(1), 1);
    const Generator* splitSlot = JointProgressive().ForChild(jointScramble(1), 4);

    RegisterBenchmark("step contexts", stepContexts)->Arg(4096);
    for (unsigned i = 0; const char* target = batchTarget(i); ++i) {
        const auto add = [&](const std::string& what, auto function) {
            return RegisterBenchmark((what + " " + target).c_str(),
                                     [target, function](benchmark::State& state) {
                                         const std::string before = chosenBatchTarget();
                                         forceBatchTarget(target);
                                         function(state);
                                         forceBatchTarget(before.c_str());
                                     });
        };
        add("coherent 1D", [](auto& s) { draw(s, Access::coherent, draw1D); })->Arg(4096);
        add("coherent 2D", [](auto& s) { draw(s, Access::coherent, draw2D); })
            ->Arg(16)
            ->Arg(256)
            ->Arg(4096)
            ->Arg(65536);
        add("coherent 3D", [](auto& s) { draw(s, Access::coherent, draw3D); })->Arg(4096);
        add("random 2D", [](auto& s) { draw(s, Access::random, draw2D); })->Arg(4096)->Arg(65536);
        add("joint coherent 1D", [=](auto& s) {
            draw(s, Access::coherent, draw1D, slot);
        })->Arg(4096);
        add("joint coherent 2D", [=](auto& s) { draw(s, Access::coherent, draw2D, slot); })
            ->Arg(16)
            ->Arg(256)
            ->Arg(4096)
            ->Arg(65536);
        add("joint coherent 3D", [=](auto& s) {
            draw(s, Access::coherent, draw3D, slot);
        })->Arg(4096);
        add("joint random 2D", [=](auto& s) { draw(s, Access::random, draw2D, slot); })
            ->Arg(4096)
            ->Arg(65536);
        add("split joint random 2D", [=](auto& s) {
            draw(s, Access::random, draw2D, splitSlot);
        })->Arg(4096);
        add("one pattern 2D", [](auto& s) { draw(s, Access::onePattern, draw2D); })->Arg(4096);
        add("new domains", derive)->Arg(4096);
        add("new domains, draw 2D", deriveThenDraw)->Arg(4096);
        add("hash to random", hashes)->Arg(4096);
    }
}

} // namespace wellstrat
