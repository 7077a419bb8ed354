// SPDX-License-Identifier: Apache-2.0
//
// How one and two threads scale. The counter is the time per sample of all threads together, so it
// halves where two threads do not disturb each other.

#include "scenarios.h"

#include <cstdlib>

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 4096;

/// Calls fill(contexts) in each thread, on contexts of the thread's own.
template <typename Fill>
void inThreads(benchmark::State& state, Fill fill) {
    std::vector<SampleCtx> contexts = makeContexts(kPoints, Access::coherent);
    for (SampleCtx& sc : contexts) sc.patternid += static_cast<unsigned>(state.thread_index());
    for (auto _ : state) {
        fill(contexts);
        benchmark::ClobberMemory();
    }
    reportItems(state, kPoints);
}

void coherentBatch(benchmark::State& state) {
    std::vector<RtFloat2> xis(kPoints);
    inThreads(state, [&](std::vector<SampleCtx>& contexts) {
        generateSamples2D(kPoints, contexts.data(), xis.data());
        if (contexts[0].sampleid == 4096) {
            for (SampleCtx& sc : contexts) sc.sampleid = 0;
        }
    });
}
BENCHMARK(coherentBatch)->Name("threads: coherent 2D")->Threads(1)->Threads(2)->UseRealTime();

void hashes(benchmark::State& state) {
    std::vector<float> xis(kPoints);
    inThreads(state, [&](std::vector<SampleCtx>& contexts) {
        hashToRandom(kPoints, contexts.data(), xis.data());
    });
}
BENCHMARK(hashes)->Name("threads: hash to random")->Threads(1)->Threads(2)->UseRealTime();

void drand48Threads(benchmark::State& state) {
    std::vector<float> xis(kPoints);
    inThreads(state, [&](std::vector<SampleCtx>&) {
        for (float& xi : xis) xi = static_cast<float>(drand48());
    });
}
BENCHMARK(drand48Threads)->Name("threads: drand48")->Threads(1)->Threads(2)->UseRealTime();

} // namespace
} // namespace wellstrat
