// SPDX-License-Identifier: Apache-2.0
//
// Draws of LongProgressive, padded and from a slot, single and in batches. Named as those from the
// tables, with "long" before.

#include "wellstrat/long.h"

#include "count.h"
#include "domains.h"
#include "wellstrat/order.h"

namespace wellstrat {
namespace {

const LongProgressive kLong;

MakeDomain domainOf(Order order) {
    return [order](std::vector<SampleCtx>& contexts, std::size_t n, Access access) {
        RixRNG rng = cameraDomain(&kLong)(contexts, n, access);
        rng.order = order;
        return rng;
    };
}

const CountedPath kCounted("long", [](CountedArrays& a) {
    const RixRNG rng = a.rng(&kLong);
    for (unsigned i = 0; i < rng.numPts; ++i) a.xis[i] = rng.DrawSample2D(i);
});

const Suite kSuite([] {
    const MakeDomain padded = domainOf({}), slot = domainOf(jointOrder(1));
    addSingle("long scalar 1D", Access::coherent, padded, kDraw1D);
    addSingle("long scalar 2D", Access::coherent, padded, kDraw2D);
    addSingle("long scalar 3D", Access::coherent, padded, kDraw3D);
    addSingle("long scalar random 2D", Access::random, padded, kDraw2D);
    addSingle("long slot scalar 2D", Access::coherent, slot, kDraw2D);
    addRounds("rounds of long scalar 2D", padded);

    addBatch("long coherent 1D", {4096}, Access::coherent, padded, kDrawAll1D);
    addBatch("long coherent 2D", {16, 256, 4096, 65536}, Access::coherent, padded, kDrawAll2D);
    addBatch("long coherent 3D", {4096}, Access::coherent, padded, kDrawAll3D);
    addBatch("long random 2D", {4096, 65536}, Access::random, padded, kDrawAll2D);
    addBatch("long slot coherent 2D", {256, 4096}, Access::coherent, slot, kDrawAll2D);
    addBatch("long slot random 2D", {4096}, Access::random, slot, kDrawAll2D);
    addBatch("split long slot random 2D", {4096}, Access::random, domainOf(jointOrder(1, 4)),
             kDrawAll2D);
});

} // namespace
} // namespace wellstrat
