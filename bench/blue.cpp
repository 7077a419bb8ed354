// SPDX-License-Identifier: Apache-2.0
//
// Draws of BlueProgressive, padded and from a slot, single and in batches. Named as those from the
// tables, with "blue" before. Coherent contexts are what a renderer has of one sampleid: whole
// tiles of pixels, row by row.

#include "wellstrat/blue.h"

#include "count.h"
#include "scenarios.h"

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 1024;
constexpr auto kPadded = static_cast<Scramble>(0x2d96c92bu);
const BlueProgressive kBlue;

std::vector<SampleCtx> makeBlueContexts(std::size_t n, Access access) {
    if (access != Access::coherent) return makeContexts(n, access);
    std::vector<SampleCtx> contexts(n);
    for (unsigned i = 0; i < n; ++i) {
        const unsigned x = i % kRankTileSize, y = i / kRankTileSize;
        contexts[i] = blueContext(static_cast<int>(x), static_cast<int>(y), 1, 0);
    }
    return contexts;
}

/// Makes a new domain of the contexts, at the sampleids that they have.
RixRNG deriveFrom(std::vector<SampleCtx>& contexts, Scramble scramble, unsigned split) {
    const std::vector<SampleCtx> parents = contexts;
    const RixRNG camera(contexts.data(), static_cast<unsigned>(contexts.size()), &kBlue);
    const RixRNG domain(camera, scramble, contexts.data(), RixRNG::Split{split});
    for (std::size_t i = 0; i < contexts.size(); ++i) contexts[i].sampleid = parents[i].sampleid;
    return domain;
}

template <typename Draw>
void addSingle(const std::string& name, Access access, Draw draw, Scramble scramble = kPadded) {
    addScenario(name, {}, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts = makeBlueContexts(kPoints, access);
        drawEach(state, caches, contexts, access, deriveFrom(contexts, scramble, 1), draw);
    });
}

/// Rounds of as few draws as small batches have.
void drawRound(benchmark::State& state, Caches caches) {
    std::vector<SampleCtx> contexts =
        makeBlueContexts(static_cast<std::size_t>(state.range(0)), Access::coherent);
    drawEach(state, caches, contexts, Access::coherent, deriveFrom(contexts, kPadded, 1), kDraw2D);
}

template <typename DrawAll>
void addBatch(const std::string& name, const std::vector<int64_t>& sizes, Access access,
              DrawAll draw, Scramble scramble = kPadded, unsigned split = 1) {
    addBatches(name, sizes, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts =
            makeBlueContexts(static_cast<std::size_t>(state.range(0)), access);
        drawAll(state, caches, contexts, access, deriveFrom(contexts, scramble, split), draw);
    });
}

const CountedPath kCounted("blue", [](CountedArrays& a) {
    const RixRNG rng = a.rng(&kBlue);
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
});

const Suite kSuite([] {
    addSingle("blue scalar 1D", Access::coherent, kDraw1D);
    addSingle("blue scalar 2D", Access::coherent, kDraw2D);
    addSingle("blue scalar 3D", Access::coherent, kDraw3D);
    addSingle("blue scalar random 2D", Access::random, kDraw2D);
    addSingle("blue slot scalar 2D", Access::coherent, kDraw2D, jointScramble(1));
    addScenario("rounds of blue scalar 2D", {16, 256}, drawRound);

    const std::vector<int64_t> sizes = {16, 256, 4096, 65536};
    addBatch("blue coherent 1D", {4096}, Access::coherent, kDrawAll1D);
    addBatch("blue coherent 2D", sizes, Access::coherent, kDrawAll2D);
    addBatch("blue coherent 3D", {4096}, Access::coherent, kDrawAll3D);
    addBatch("blue random 2D", {4096, 65536}, Access::random, kDrawAll2D);
    addBatch("blue slot coherent 2D", {256, 4096}, Access::coherent, kDrawAll2D, jointScramble(1));
    addBatch("blue slot random 2D", {4096}, Access::random, kDrawAll2D, jointScramble(1));
    addBatch("split blue slot random 2D", {4096}, Access::random, kDrawAll2D, jointScramble(1), 4);
});

} // namespace
} // namespace wellstrat
