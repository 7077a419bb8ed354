// SPDX-License-Identifier: Apache-2.0
//
// Batches of the computed sequence in vector code; see vector.cpp.
//
// Each function here has the name of the scalar function whose bits it computes.

#include "batch/vector_targets.h"

#include "wellstrat/sequence_slots.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/sequence_vector.cpp"
#include "hwy/foreach_target.h"

#include "batch/sequence_vector.h"
#include "batch/sequence_words.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {
namespace {

// The orders of samples: point(seed, sampleid) has the digits of their points.

/// sequenceIndex. What it needs of the sampleids is kept from vector to vector, since those of a
/// coherent batch are all the same.
class ShuffledSequence {
public:
    HWY_INLINE ShuffledSequence() : sampleid_(hn::Zero(kWords)), reversed_(sampleid_) {}

    HWY_INLINE PointVectors point(V seed, V sampleid) {
        if (!hn::AllTrue(kWords, hn::Eq(sampleid, sampleid_))) {
            sampleid_ = sampleid;
            reversed_ = reverseBits(sampleid);
            hasLater_ = !hn::AllFalse(kWords, hn::Gt(sampleid, constant(0xffff)));
        }
        const V hashed = owenHash(reversed_, seed);
        if (HWY_LIKELY(!hasLater_)) return sequenceDigitsOfReversed<16>(hashed);
        const V undone = hn::And(owenHash(hn::Zero(kWords), seed), constant(0xffff));
        return sequenceDigitsOfReversed<32>(hn::Xor(hashed, undone));
    }

private:
    V sampleid_, reversed_;
    bool hasLater_ = false;
};

/// slotDigits without splits. What the bank gives is kept in the same way.
class SlotSequence {
public:
    HWY_INLINE explicit SlotSequence(unsigned slot)
        : slot_(slot), sampleid_(hn::Zero(kWords)), places_(sampleid_), swapped_(sampleid_),
          block_(sampleid_) {}

    HWY_INLINE PointVectors point(V seed, V sampleid) {
        if (!hn::AllTrue(kWords, hn::Eq(sampleid, sampleid_))) keep(sampleid);
        const auto swapped = hn::TestBit(seed, constant(1u << 31));
        V index = hn::IfThenElse(swapped, swapped_, places_);
        V y = hn::IfThenElse(swapped, places_, swapped_);
        if (HWY_UNLIKELY(hasBlocks_)) {
            const V block =
                hn::IfThenZeroElse(hn::Eq(block_, hn::Zero(kWords)),
                                   hn::Xor(reverseBits(owenHash(reverseBits(block_), seed)),
                                           reverseBits(owenHash(hn::Zero(kWords), seed))));
            index = hn::Xor(index, block);
            y = hn::Xor(y, pascalTimes(block));
        }
        return {index, y, trinomialTimes(index)};
    }

private:
    HWY_NOINLINE void keep(V sampleid) {
        HWY_ALIGN uint32_t ids[kLanes];
        HWY_ALIGN uint32_t both[kLanes];
        hn::Store(sampleid, kWords, ids);
        for (std::size_t i = 0; i < kLanes; ++i) both[i] = detail::slotPlaces(0, slot_, ids[i]);
        sampleid_ = sampleid;
        places_ = hn::And(hn::Load(kWords, both), constant(0xffff));
        swapped_ = hn::ShiftRight<16>(hn::Load(kWords, both));
        block_ = hn::And(sampleid, constant(~((1u << kSlotDigits) - 1)));
        hasBlocks_ = !hn::AllTrue(kWords, hn::Eq(block_, hn::Zero(kWords)));
    }

    unsigned slot_;
    V sampleid_, places_, swapped_, block_;
    bool hasBlocks_ = false;
};

/// splitSlotIndex, sample by sample.
class SplitSlotSequence {
public:
    SplitSlotSequence(unsigned slot, unsigned split) : slot_(slot), split_(split) {}

    HWY_INLINE PointVectors point(V seed, V sampleid) const {
        HWY_ALIGN uint32_t seeds[kLanes];
        HWY_ALIGN uint32_t words[kLanes];
        hn::Store(seed, kWords, seeds);
        hn::Store(sampleid, kWords, words);
        for (std::size_t i = 0; i < kLanes; ++i) {
            words[i] = detail::splitSlotIndex(seeds[i], words[i], slot_, split_);
        }
        return sequenceDigits(hn::Load(kWords, words));
    }

private:
    unsigned slot_, split_;
};

template <typename Order, typename Sample>
HWY_INLINE void drawInOrder(std::size_t n, const SampleCtx* contexts, Order order, Sample* xis) {
    forVectors(n, contexts, xis, [&order](const SampleCtx* some, Sample* results) {
        V patternid, sampleid;
        load(some, patternid, sampleid);
        const V seed = sequenceSeed(patternid);
        storeScrambled(order.point(seed, sampleid), seed, results);
    });
}

template <typename Sample>
HWY_INLINE void draw(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                     Sample* xis) {
    if (slot == kJointSlots) return drawInOrder(n, contexts, ShuffledSequence(), xis);
    if (split == 1) return drawInOrder(n, contexts, SlotSequence(slot), xis);
    drawInOrder(n, contexts, SplitSlotSequence(slot, split), xis);
}

} // namespace

void drawSequence1D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                    float* xis) {
    draw(n, contexts, slot, split, xis);
}

void drawSequence2D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                    Float2* xis) {
    draw(n, contexts, slot, split, xis);
}

void drawSequence3D(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                    Float3* xis) {
    draw(n, contexts, slot, split, xis);
}

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif
