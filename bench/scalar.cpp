// SPDX-License-Identifier: Apache-2.0
//
// Single draws, inlined into the caller's loop.

#include "scenarios.h"
#include "wellstrat/random_generator.h"

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 1024;

template <typename Draw>
void add(const std::string& name, Access access, Draw draw, const Generator* generator = nullptr) {
    addScenario(name, {}, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts = makeContexts(kPoints, access);
        const RixRNG rng(contexts.data(), kPoints, generator);
        drawEach(state, caches, contexts, access, rng, draw);
    });
}

/// Rounds of as few draws as small batches have, which with cluttered caches is what to compare
/// them with.
void drawRound(benchmark::State& state, Caches caches) {
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<SampleCtx> contexts = makeContexts(n, Access::coherent);
    const RixRNG rng(contexts.data(), static_cast<unsigned>(n));
    drawEach(state, caches, contexts, Access::coherent, rng, kDraw2D);
}

const Suite kSuite([] {
    static const RandomGenerator unstratified;
    add("scalar 1D", Access::coherent, kDraw1D);
    add("scalar 2D", Access::coherent, kDraw2D);
    add("scalar 3D", Access::coherent, kDraw3D);
    addScenario("rounds of scalar 2D", {16, 256}, drawRound);
    add("scalar random 1D", Access::random, kDraw1D);
    add("scalar random 2D", Access::random, kDraw2D);
    add("scalar random 3D", Access::random, kDraw3D);
    add("scalar 2D by RandomGenerator", Access::coherent, kDraw2D, &unstratified);
});

} // namespace
} // namespace wellstrat
