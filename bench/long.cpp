// SPDX-License-Identifier: Apache-2.0
//
// Draws of LongProgressive, padded and from a slot, single and in batches. Named as those from the
// tables, with "long" before.

#include "wellstrat/long.h"

#include "count.h"
#include "scenarios.h"
#include "wellstrat/order.h"

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 1024;
const LongProgressive kLong;
constexpr Order kPadded;

RixRNG viewOf(std::vector<SampleCtx>& contexts, Order order) {
    RixRNG rng(contexts.data(), static_cast<unsigned>(contexts.size()), &kLong);
    rng.order = order;
    return rng;
}

template <typename Draw>
void addSingle(const std::string& name, Access access, Draw draw, Order order = kPadded) {
    addScenario(name, {}, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts = makeContexts(kPoints, access);
        drawEach(state, caches, contexts, access, viewOf(contexts, order), draw);
    });
}

/// Rounds of as few draws as small batches have.
void drawRound(benchmark::State& state, Caches caches) {
    std::vector<SampleCtx> contexts =
        makeContexts(static_cast<std::size_t>(state.range(0)), Access::coherent);
    drawEach(state, caches, contexts, Access::coherent, viewOf(contexts, kPadded), kDraw2D);
}

template <typename DrawAll>
void addBatch(const std::string& name, const std::vector<int64_t>& sizes, Access access,
              DrawAll draw, Order order = kPadded) {
    addBatches(name, sizes, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts =
            makeContexts(static_cast<std::size_t>(state.range(0)), access);
        drawAll(state, caches, contexts, access, viewOf(contexts, order), draw);
    });
}

const CountedPath kCounted("long", [](CountedArrays& a) {
    const RixRNG rng = a.rng(&kLong);
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
});

const Suite kSuite([] {
    addSingle("long scalar 1D", Access::coherent, kDraw1D);
    addSingle("long scalar 2D", Access::coherent, kDraw2D);
    addSingle("long scalar 3D", Access::coherent, kDraw3D);
    addSingle("long scalar random 2D", Access::random, kDraw2D);
    addSingle("long slot scalar 2D", Access::coherent, kDraw2D, jointOrder(1));
    addScenario("rounds of long scalar 2D", {16, 256}, drawRound);

    const std::vector<int64_t> sizes = {16, 256, 4096, 65536};
    addBatch("long coherent 1D", {4096}, Access::coherent, kDrawAll1D);
    addBatch("long coherent 2D", sizes, Access::coherent, kDrawAll2D);
    addBatch("long coherent 3D", {4096}, Access::coherent, kDrawAll3D);
    addBatch("long random 2D", {4096, 65536}, Access::random, kDrawAll2D);
    addBatch("long slot coherent 2D", {256, 4096}, Access::coherent, kDrawAll2D, jointOrder(1));
    addBatch("long slot random 2D", {4096}, Access::random, kDrawAll2D, jointOrder(1));
    addBatch("split long slot random 2D", {4096}, Access::random, kDrawAll2D, jointOrder(1, 4));
});

} // namespace
} // namespace wellstrat
