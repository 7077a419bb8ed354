// SPDX-License-Identifier: Apache-2.0
//
// Draws from a slot of JointProgressive, single and in batches.

#include "wellstrat/joint.h"

#include "count.h"
#include "scenarios.h"

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 1024;
const JointProgressive kJoint;

/// Makes slot 1 of contexts, under a split, and leaves them at the sampleids that they have.
RixRNG deriveSlot(std::vector<SampleCtx>& contexts, unsigned split) {
    const std::vector<SampleCtx> parents = contexts;
    const RixRNG camera(contexts.data(), static_cast<unsigned>(contexts.size()), &kJoint);
    const RixRNG slot(camera, jointScramble(1), contexts.data(), RixRNG::Split{split});
    for (std::size_t i = 0; i < contexts.size(); ++i) contexts[i].sampleid = parents[i].sampleid;
    return slot;
}

template <typename Draw>
void addSingle(const std::string& name, Access access, Draw draw) {
    addScenario(name, {}, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts = makeContexts(kPoints, access);
        drawEach(state, caches, contexts, access, deriveSlot(contexts, 1), draw);
    });
}

/// What a padded domain of a JointProgressive costs more than one without a generator.
void drawPadded(benchmark::State& state, Caches caches) {
    std::vector<SampleCtx> contexts = makeContexts(kPoints, Access::coherent);
    const RixRNG rng(contexts.data(), kPoints, &kJoint);
    drawEach(state, caches, contexts, Access::coherent, rng, kDraw2D);
}

template <typename DrawAll>
void addBatch(const std::string& name, const std::vector<int64_t>& sizes, Access access,
              DrawAll draw, unsigned split = 1) {
    addBatches(name, sizes, [=](benchmark::State& state, Caches caches) {
        const auto n = static_cast<std::size_t>(state.range(0));
        std::vector<SampleCtx> contexts = makeContexts(n, access);
        drawAll(state, caches, contexts, access, deriveSlot(contexts, split), draw);
    });
}

/// With what deriving the slot takes, in one batch.
const CountedPath kCounted("joint", [](CountedArrays& a) {
    const RixRNG rng(a.rng(&kJoint), jointScramble(1), a.children.data());
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
});

const Suite kSuite([] {
    addSingle("joint scalar 1D", Access::coherent, kDraw1D);
    addSingle("joint scalar 2D", Access::coherent, kDraw2D);
    addSingle("joint scalar 3D", Access::coherent, kDraw3D);
    addSingle("joint scalar random 2D", Access::random, kDraw2D);
    addScenario("scalar 2D by JointProgressive, padded", {}, drawPadded);

    addBatch("joint coherent 1D", {4096}, Access::coherent, kDrawAll1D);
    addBatch("joint coherent 2D", {16, 256, 4096, 65536}, Access::coherent, kDrawAll2D);
    addBatch("joint coherent 3D", {4096}, Access::coherent, kDrawAll3D);
    addBatch("joint random 2D", {4096, 65536}, Access::random, kDrawAll2D);
    addBatch("split joint random 2D", {4096}, Access::random, kDrawAll2D, 4);
});

} // namespace
} // namespace wellstrat
