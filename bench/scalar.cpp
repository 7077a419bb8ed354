// SPDX-License-Identifier: Apache-2.0
//
// Single draws, inlined into the caller's loop.

#include "contexts.h"
#include "wellstrat/joint.h"
#include "wellstrat/random_generator.h"

#include <utility>

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 1024;
constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);

/// Fills an array with draw(rng, i) for each point, one sampleid on with each iteration.
template <typename Draw>
void drawEach(benchmark::State& state, Draw draw, const Generator* generator = nullptr) {
    std::vector<SampleCtx> contexts = makeContexts(kPoints, Access::coherent);
    std::vector<decltype(draw(std::declval<const RixRNG&>(), 0u))> xis(kPoints);
    const RixRNG rng(contexts.data(), kPoints, generator);
    for (auto _ : state) {
        for (SampleCtx& sc : contexts) sc.sampleid = (sc.sampleid + 1) % 4096;
        for (unsigned i = 0; i < kPoints; ++i) xis[i] = draw(rng, i);
        benchmark::ClobberMemory();
    }
    reportItems(state, kPoints);
}

constexpr auto draw1D = [](const RixRNG& rng, unsigned i) { return rng.DrawSample1D(i); };
constexpr auto draw2D = [](const RixRNG& rng, unsigned i) { return rng.DrawSample2D(i); };
constexpr auto draw3D = [](const RixRNG& rng, unsigned i) { return rng.DrawSample3D(i); };

void scalar1D(benchmark::State& state) { drawEach(state, draw1D); }
void scalar2D(benchmark::State& state) { drawEach(state, draw2D); }
void scalar3D(benchmark::State& state) { drawEach(state, draw3D); }
BENCHMARK(scalar1D)->Name("scalar 1D");
BENCHMARK(scalar2D)->Name("scalar 2D");
BENCHMARK(scalar3D)->Name("scalar 3D");

template <typename Draw>
void drawEachFromSlot(benchmark::State& state, Draw draw) {
    drawEach(state, draw, JointProgressive().ForChild(jointScramble(1), 1));
}

void joint1D(benchmark::State& state) { drawEachFromSlot(state, draw1D); }
void joint2D(benchmark::State& state) { drawEachFromSlot(state, draw2D); }
void joint3D(benchmark::State& state) { drawEachFromSlot(state, draw3D); }
BENCHMARK(joint1D)->Name("joint scalar 1D");
BENCHMARK(joint2D)->Name("joint scalar 2D");
BENCHMARK(joint3D)->Name("joint scalar 3D");

/// What a padded domain of a JointProgressive costs more than one without a generator.
void padded2D(benchmark::State& state) {
    const JointProgressive joint;
    drawEach(state, draw2D, &joint);
}
BENCHMARK(padded2D)->Name("scalar 2D by JointProgressive, padded");

void scalar2DRandom(benchmark::State& state) {
    const RandomGenerator generator;
    drawEach(state, draw2D, &generator);
}
BENCHMARK(scalar2DRandom)->Name("scalar 2D by RandomGenerator");

/// As a path does: derive a domain from the last one, draw, 16 times; one sampleid on with each
/// iteration, as all pixels of a tile are.
void chain2D(benchmark::State& state) {
    constexpr unsigned depth = 16;
    const std::vector<SampleCtx> contexts = makeContexts(kPoints, Access::coherent);
    RtFloat2 xis[depth];
    unsigned sampleid = 0;
    for (auto _ : state) {
        sampleid = (sampleid + 1) % 4096;
        for (SampleCtx sc : contexts) {
            sc.sampleid = sampleid;
            for (RtFloat2& xi : xis) {
                sc = sc.NewDomain(kScramble);
                xi = sample2D(sc.patternid, sc.sampleid);
            }
            benchmark::DoNotOptimize(xis);
        }
    }
    reportItems(state, kPoints * depth);
}
BENCHMARK(chain2D)->Name("scalar new domain, draw 2D, chain of 16");

} // namespace
} // namespace wellstrat
