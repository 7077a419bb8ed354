// SPDX-License-Identifier: Apache-2.0
//
// Draws from a slot of JointProgressive, single and in batches.

#include "wellstrat/joint.h"

#include "count.h"
#include "domains.h"

namespace wellstrat {
namespace {

const JointProgressive kJoint;

MakeDomain slotUnderSplit(unsigned split) {
    return [split](std::vector<SampleCtx>& contexts, std::size_t n, Access access) {
        contexts = makeContexts(n, access);
        return deriveInPlace(contexts, kJoint, jointScramble(1), split);
    };
}

/// With what deriving the slot takes, in one batch.
const CountedPath kCounted("joint", [](CountedArrays& a) {
    const RixRNG rng(a.rng(&kJoint), jointScramble(1), a.children.data());
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
});

const Suite kSuite([] {
    const MakeDomain slot = slotUnderSplit(1), split = slotUnderSplit(4);
    addSingle("joint scalar 1D", Access::coherent, slot, kDraw1D);
    addSingle("joint scalar 2D", Access::coherent, slot, kDraw2D);
    addSingle("joint scalar 3D", Access::coherent, slot, kDraw3D);
    addSingle("joint scalar random 2D", Access::random, slot, kDraw2D);
    addSingle("split joint scalar 2D", Access::coherent, split, kDraw2D);
    // What a padded domain of a JointProgressive costs more than one without a generator.
    addSingle("scalar 2D by JointProgressive, padded", Access::coherent, cameraDomain(&kJoint),
              kDraw2D);

    addBatch("joint coherent 1D", {4096}, Access::coherent, slot, kDrawAll1D);
    addBatch("joint coherent 2D", {16, 256, 4096, 65536}, Access::coherent, slot, kDrawAll2D);
    addBatch("joint coherent 3D", {4096}, Access::coherent, slot, kDrawAll3D);
    addBatch("joint random 2D", {4096, 65536}, Access::random, slot, kDrawAll2D);
    addBatch("split joint random 2D", {4096}, Access::random, split, kDrawAll2D);
});

} // namespace
} // namespace wellstrat
