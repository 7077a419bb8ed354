// SPDX-License-Identifier: Apache-2.0
//
// Draws of BlueProgressive, padded and from a slot, single and in batches. Named as those from the
// tables, with "blue" before. Coherent contexts are what a renderer has of one sampleid: whole
// tiles of pixels, row by row.

#include "wellstrat/blue.h"

#include "count.h"
#include "domains.h"

namespace wellstrat {
namespace {

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

MakeDomain derived(Scramble scramble, unsigned split = 1) {
    return [=](std::vector<SampleCtx>& contexts, std::size_t n, Access access) {
        contexts = makeBlueContexts(n, access);
        return deriveInPlace(contexts, kBlue, scramble, split);
    };
}

const CountedPath kCounted("blue", [](CountedArrays& a) {
    const RixRNG rng = a.rng(&kBlue);
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
});

const Suite kSuite([] {
    const MakeDomain padded = derived(static_cast<Scramble>(0x2d96c92bu));
    const MakeDomain slot = derived(jointScramble(1));
    addSingle("blue scalar 1D", Access::coherent, padded, kDraw1D);
    addSingle("blue scalar 2D", Access::coherent, padded, kDraw2D);
    addSingle("blue scalar 3D", Access::coherent, padded, kDraw3D);
    addSingle("blue scalar random 2D", Access::random, padded, kDraw2D);
    addSingle("blue slot scalar 2D", Access::coherent, slot, kDraw2D);
    addRounds("rounds of blue scalar 2D", padded);

    addBatch("blue coherent 1D", {4096}, Access::coherent, padded, kDrawAll1D);
    addBatch("blue coherent 2D", {16, 256, 4096, 65536}, Access::coherent, padded, kDrawAll2D);
    addBatch("blue coherent 3D", {4096}, Access::coherent, padded, kDrawAll3D);
    addBatch("blue random 2D", {4096, 65536}, Access::random, padded, kDrawAll2D);
    addBatch("blue slot coherent 2D", {256, 4096}, Access::coherent, slot, kDrawAll2D);
    addBatch("blue slot random 2D", {4096}, Access::random, slot, kDrawAll2D);
    addBatch("split blue slot random 2D", {4096}, Access::random, derived(jointScramble(1), 4),
             kDrawAll2D);
});

} // namespace
} // namespace wellstrat
