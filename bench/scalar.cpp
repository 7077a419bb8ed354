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

const Suite kSuite([] {
    static const RandomGenerator unstratified;
    add("scalar 1D", Access::coherent, kDraw1D);
    add("scalar 2D", Access::coherent, kDraw2D);
    add("scalar 3D", Access::coherent, kDraw3D);
    add("scalar random 1D", Access::random, kDraw1D);
    add("scalar random 2D", Access::random, kDraw2D);
    add("scalar random 3D", Access::random, kDraw3D);
    add("scalar 2D by RandomGenerator", Access::coherent, kDraw2D, &unstratified);
});

} // namespace
} // namespace wellstrat
