// SPDX-License-Identifier: Apache-2.0
//
// The orders of the samples of computed points, on vectors. Included once for each target, as
// vector_words.h.
//
// Each class has the name of what it computes: point(seed, sampleid) gives the digits of the
// points.

#if defined(WELLSTRAT_BATCH_SEQUENCE_ORDERS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_SEQUENCE_ORDERS_H
#undef WELLSTRAT_BATCH_SEQUENCE_ORDERS_H
#else
#define WELLSTRAT_BATCH_SEQUENCE_ORDERS_H
#endif

#include "batch/sequence_words.h"

#include "wellstrat/sequence_slots.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

/// sequenceIndex. What it needs of the sampleids is kept from vector to vector, since those of a
/// coherent batch are all the same.
class ShuffledSequence {
public:
    HWY_INLINE ShuffledSequence() : sampleid_(hn::Zero(kWords)), reversed_(sampleid_) {}

    HWY_INLINE PointVectors point(V seed, V sampleid) {
        if (!same(sampleid, sampleid_)) {
            sampleid_ = sampleid;
            reversed_ = reverseBits(sampleid);
            hasLater_ = !hn::AllFalse(kWords, hn::Gt(sampleid, constant(0xffff)));
        }
        const V key = shuffleKey(seed);
        const V hashed = owenHash(reversed_, key);
        if (HWY_LIKELY(!hasLater_)) return sequenceDigitsOfReversed<16>(hashed);
        const V undone = hn::And(owenHash(hn::Zero(kWords), key), constant(0xffff));
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
        if (!same(sampleid, sampleid_)) keep(sampleid);
        const auto swapped = hn::TestBit(seed, constant(1u << 31));
        V index = hn::IfThenElse(swapped, swapped_, places_);
        V y = hn::IfThenElse(swapped, places_, swapped_);
        if (HWY_UNLIKELY(hasBlocks_)) {
            const V key = shuffleKey(seed);
            const V block =
                hn::IfThenZeroElse(hn::Eq(block_, hn::Zero(kWords)),
                                   hn::Xor(reverseBits(owenHash(reverseBits(block_), key)),
                                           reverseBits(owenHash(hn::Zero(kWords), key))));
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
        for (std::size_t i = 0; i < kLanes; ++i) {
            both[i] = detail::slotPlaces(detail::kSlotOrders, 0, slot_, ids[i]);
        }
        sampleid_ = sampleid;
        places_ = hn::And(hn::Load(kWords, both), constant(0xffff));
        swapped_ = hn::ShiftRight<16>(hn::Load(kWords, both));
        block_ = hn::And(sampleid, constant(~((1u << kSlotDigits) - 1)));
        hasBlocks_ = !same(block_, hn::Zero(kWords));
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
            words[i] =
                detail::splitSlotIndex(detail::kSlotOrders, seeds[i], words[i], slot_, split_);
        }
        return sequenceDigits(hn::Load(kWords, words));
    }

private:
    unsigned slot_, split_;
};

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#endif
