// SPDX-License-Identifier: Apache-2.0
//
// A scenario is a round of draws that is run again and again. It has two names: with warm caches,
// where nothing happens between rounds, and with "cluttered " before it, where the caches are full
// of something else when a round begins.

#pragma once

#include "clutter.h"
#include "contexts.h"
#include "wellstrat/batch_target.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat {

enum class Caches { warm, cluttered };

/// What a file adds to the benchmarks: constructed before main, called by it with the tables built.
class Suite {
public:
    explicit Suite(void (*add)());
    static void addAll();
};

/// Reports nanoseconds per item, of which each iteration makes `items`. The script reads the
/// counter, which is the inverse of a rate in 10^9 items a second.
inline void reportItems(benchmark::State& state, std::size_t items) {
    using benchmark::Counter;
    state.counters["ns"] =
        Counter(static_cast<double>(state.iterations()) * static_cast<double>(items) * 1e-9,
                Counter::kIsRate | Counter::kInvert);
}

/// Runs rounds of `items` draws, each from contexts that have been stepped on.
///
/// With warm caches the steps are measured too. With cluttered ones nothing but round() is: the
/// contexts are in the caches, since a renderer has just made them; tables, code and results are
/// not. Reported is the median of the rounds, as a single one is too short to wait for a quiet
/// moment of the machine.
template <typename Round>
void runRounds(benchmark::State& state, Caches caches, std::vector<SampleCtx>& contexts,
               Access access, std::size_t items, Round round) {
    benchmark::DoNotOptimize(contexts.data());
    if (caches == Caches::warm) {
        for (auto _ : state) {
            stepContexts(contexts, access);
            round();
            benchmark::ClobberMemory();
        }
        reportItems(state, items);
        return;
    }
    std::vector<double> seconds;
    for (auto _ : state) {
        clutterCaches();
        stepContexts(contexts, access);
        for (const SampleCtx& sc : contexts) benchmark::DoNotOptimize(sc.patternid);
        Stopwatch watch;
        watch.start();
        round();
        benchmark::ClobberMemory();
        seconds.push_back(watch.stop());
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    state.counters["ns"] = *middle * 1e9 / static_cast<double>(items);
}

/// Draws each point of `rng`, a view of `contexts`, by itself: draw(rng, i).
template <typename Draw>
void drawEach(benchmark::State& state, Caches caches, std::vector<SampleCtx>& contexts,
              Access access, const RixRNG& rng, Draw draw) {
    std::vector<decltype(draw(rng, 0u))> xis(contexts.size());
    benchmark::DoNotOptimize(xis.data());
    runRounds(state, caches, contexts, access, xis.size(), [&] {
        for (unsigned i = 0; i < xis.size(); ++i) xis[i] = draw(rng, i);
    });
}

/// Draws all points of `rng`, a view of `contexts`, in one batch: draw(rng, xis).
template <typename Sample>
void drawAll(benchmark::State& state, Caches caches, std::vector<SampleCtx>& contexts,
             Access access, const RixRNG& rng, void (*draw)(const RixRNG&, Sample*)) {
    std::vector<Sample> xis(contexts.size());
    benchmark::DoNotOptimize(xis.data());
    runRounds(state, caches, contexts, access, xis.size(), [&] { draw(rng, xis.data()); });
}

// What drawEach and drawAll take.
constexpr auto kDraw1D = [](const RixRNG& rng, unsigned i) { return rng.DrawSample1D(i); };
constexpr auto kDraw2D = [](const RixRNG& rng, unsigned i) { return rng.DrawSample2D(i); };
constexpr auto kDraw3D = [](const RixRNG& rng, unsigned i) { return rng.DrawSample3D(i); };
constexpr auto kDrawAll1D = +[](const RixRNG& rng, float* xis) { rng.DrawSamples1D(xis); };
constexpr auto kDrawAll2D = +[](const RixRNG& rng, RtFloat2* xis) { rng.DrawSamples2D(xis); };
constexpr auto kDrawAll3D = +[](const RixRNG& rng, RtFloat3* xis) { rng.DrawSamples3D(xis); };

/// Adds run(state, caches) under both names, for each size that state.range(0) is to have.
template <typename Run>
void addScenario(const std::string& name, const std::vector<int64_t>& sizes, Run run) {
    for (const Caches caches : {Caches::warm, Caches::cluttered}) {
        const std::string full = (caches == Caches::cluttered ? "cluttered " : "") + name;
        auto* added = benchmark::RegisterBenchmark(
            full.c_str(), [run, caches](benchmark::State& state) { run(state, caches); });
        for (const int64_t size : sizes) added->Arg(size);
    }
}

/// Adds a scenario of batches for each target that the processor can run, named after it.
template <typename Run>
void addBatches(const std::string& name, const std::vector<int64_t>& sizes, Run run) {
    for (unsigned i = 0; const char* target = batchTarget(i); ++i) {
        addScenario(name + " " + target, sizes, [=](benchmark::State& state, Caches caches) {
            forceBatchTarget(target);
            run(state, caches);
            forceBatchTarget(batchTarget(0));
        });
    }
}

} // namespace wellstrat
