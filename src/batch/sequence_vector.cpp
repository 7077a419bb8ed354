// SPDX-License-Identifier: Apache-2.0
//
// Batches of the computed sequence in vector code; see vector.cpp.
//
// Each function here has the name of the scalar function whose bits it computes.

#include "batch/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/sequence_vector.cpp"
#include "hwy/foreach_target.h"

#include "batch/sequence_orders.h"
#include "batch/sequence_vector.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {
namespace {

/// Each order has code of its own, so that a batch fetches no more of it than it runs.
template <typename Order, typename Sample>
HWY_NOINLINE void drawInOrder(std::size_t n, const SampleCtx* contexts, Order order, Sample* xis) {
    forVectors(n, contexts, xis, [&order](const SampleCtx* some, Sample* results) {
        V patternid, sampleid;
        load(some, patternid, sampleid);
        const V seed = sequenceSeed(patternid);
        storeScrambled(order.point(seed, sampleid), ScramblingKeys(seed), results);
    });
}

} // namespace

template <typename Sample>
void drawSequence(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                  Sample* xis) {
    if (slot == kJointSlots) return drawInOrder(n, contexts, ShuffledSequence(), xis);
    if (split == 1) return drawInOrder(n, contexts, SlotSequence(slot), xis);
    drawInOrder(n, contexts, SplitSlotSequence(slot, split), xis);
}

template void drawSequence(std::size_t, const SampleCtx*, unsigned, unsigned, float*);
template void drawSequence(std::size_t, const SampleCtx*, unsigned, unsigned, Float2*);
template void drawSequence(std::size_t, const SampleCtx*, unsigned, unsigned, Float3*);
template void drawSequence(std::size_t, const SampleCtx*, unsigned, unsigned, uint32_t*);
template void drawSequence(std::size_t, const SampleCtx*, unsigned, unsigned, Bits2*);
template void drawSequence(std::size_t, const SampleCtx*, unsigned, unsigned, Bits3*);

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif
