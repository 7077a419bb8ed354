// SPDX-License-Identifier: Apache-2.0
//
// The orders of the samples of the tables, on vectors. Included once for each target, as
// vector_words.h.
//
// Each function here has the name of the scalar function whose bits it computes.

#if defined(WELLSTRAT_BATCH_TABLE_ORDERS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_TABLE_ORDERS_H
#undef WELLSTRAT_BATCH_TABLE_ORDERS_H
#else
#define WELLSTRAT_BATCH_TABLE_ORDERS_H
#endif

#include "batch/joint_digits.h"
#include "batch/vector_words.h"

#include "wellstrat/lookup.h"

#include <type_traits>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

HWY_INLINE V reverseLowByte(V x) {
    alignas(16) static constexpr uint8_t kReversed[16] = {0, 8, 4, 12, 2, 10, 6, 14,
                                                          1, 9, 5, 13, 3, 11, 7, 15};
    constexpr Bytes bytes;
    const auto table = hn::LoadDup128(bytes, kReversed);
    const V nibble = constant(15);
    const auto reversed = [&](V nibbles) {
        return hn::BitCast(kWords, lookUpBytes(table, hn::BitCast(bytes, nibbles)));
    };
    const V low = reversed(hn::And(x, nibble));
    const V high = reversed(hn::And(hn::ShiftRight<4>(x), nibble));
    return hn::Or(hn::ShiftLeft<28>(low), hn::ShiftLeft<24>(high));
}

HWY_INLINE V patternSeed(V patternid) {
    return mixBits(hn::Add(patternid, constant(detail::kGolden)));
}

/// What the shuffle begins with: the low byte of the sampleid in opposite order, and its group.
HWY_INLINE V shuffleStart(V sampleid) {
    return hn::Or(reverseLowByte(sampleid), hn::And(sampleid, constant(~(kGroupSize - 1))));
}

HWY_INLINE V shuffledPlaceFrom(V start, V seed) {
    V r = hn::Mul(hn::Add(start, seed), hn::Add(hn::Add(seed, seed), constant(1)));
    r = hn::Xor(r, hn::Mul(r, constant(0x3d20adeau)));
    r = hn::Xor(r, hn::Mul(r, constant(0x05526c56u)));
    return hn::ShiftRight<24>(r);
}

HWY_INLINE V shuffledPlace(V seed, V sampleid) {
    return shuffledPlaceFrom(shuffleStart(sampleid), seed);
}

HWY_INLINE V scaleToRange(V x, uint32_t n) {
    return hn::ShiftRight<23>(hn::Mul(hn::ShiftRight<9>(x), constant(n)));
}

/// What tableOfBlock adds to the seed.
HWY_INLINE V blockStep(V sampleid) {
    return hn::Mul(hn::ShiftRight<kTableSizeLog2>(sampleid), constant(kBlockStep));
}

/// Where the first place of a group lies in a table that is chosen by this word.
HWY_INLINE V offsetOf(V tableWord, V groupStart) {
    return hn::Add(hn::Mul(groupStart, constant(kTableCount)),
                   hn::ShiftLeft<8>(scaleToRange(tableWord, kTableCount)));
}

HWY_INLINE V groupStartOf(V sampleid) {
    return hn::And(sampleid, constant(kTableSize - kGroupSize));
}

// The orders of samples. offset(seed, sampleid) is where the points of samples below `end` lie. For
// others it means nothing, but is always inside the tables.

/// sampleOffset. What it needs of the sampleids is kept from vector to vector, since those of a
/// coherent batch are all the same.
class ShuffledOrder {
public:
    static constexpr uint32_t end = kStratifiedSamples;

    HWY_INLINE ShuffledOrder()
        : sampleid_(hn::Zero(kWords)), start_(sampleid_), row_(sampleid_), blockStep_(sampleid_) {}

    HWY_INLINE V offset(V seed, V sampleid) {
        if (!same(sampleid, sampleid_)) {
            sampleid_ = sampleid;
            start_ = shuffleStart(sampleid);
            row_ = hn::Mul(groupStartOf(sampleid), constant(kTableCount));
            blockStep_ = blockStep(sampleid);
        }
        const V table = scaleToRange(hn::Add(seed, blockStep_), kTableCount);
        return hn::Add(hn::Add(row_, hn::ShiftLeft<8>(table)), shuffledPlaceFrom(start_, seed));
    }

private:
    V sampleid_, start_, row_, blockStep_;
};

/// Both orders of an index at once, as JointDigits has them. In vectors of 8 or more words.
class WideJointOrders {
public:
    explicit WideJointOrders(const JointDigits& digits) {
        for (int i = 0; i < kDigits; ++i) {
            tables_[i] = hn::LoadU(kWords, kBits == 3 ? digits.by3[i] : digits.by4[i]);
        }
    }

    /// Both places of the low 12 bits of `index`.
    HWY_INLINE V both(V index) const {
        V sum = hn::Xor(found(tables_[0], index), found(tables_[1], hn::ShiftRight<kBits>(index)));
        sum = hn::Xor(sum, found(tables_[2], hn::ShiftRight<2 * kBits>(index)));
        if (kDigits == 3) return sum;
        return hn::Xor(sum, found(tables_[kDigits - 1], hn::ShiftRight<3 * kBits>(index)));
    }

    /// The one for a pattern with this seed; above bit 11 anything.
    static HWY_INLINE V chosen(V both, V seed) {
        static_assert(kJointSwapBit == 16, "the number of bits that the swapped one lies higher");
        return hn::Shr(both, hn::And(seed, constant(kJointSwapBit)));
    }

private:
    static constexpr int kBits = hn::MaxLanes(kWords) >= 16 ? 4 : 3;
    static constexpr int kDigits = 12 / kBits;

    static HWY_INLINE V found(V table, V index) {
        const V digit = hn::And(index, constant((1u << kBits) - 1));
        return hn::TableLookupLanes(table, hn::IndicesFromVec(kWords, digit));
    }

    V tables_[kDigits];
};

/// The same in vectors of 4 words, by bytes.
class NarrowJointOrders {
public:
    explicit NarrowJointOrders(const JointDigits& digits) {
        for (int swap = 0; swap < 2; ++swap) {
            for (int i = 0; i < 3; ++i)
                low_[swap][i] = hn::LoadDup128(Bytes(), digits.low[swap][i]);
            high_[swap] = hn::LoadDup128(Bytes(), digits.high[swap]);
        }
    }

    HWY_INLINE V both(V index) const {
        const V digit0 = hn::And(index, constant(15));
        const V digit1 = hn::And(hn::ShiftRight<4>(index), constant(15));
        const V digit2 = hn::And(hn::ShiftRight<8>(index), constant(15));
        V places[2];
        for (int swap = 0; swap < 2; ++swap) {
            const V low =
                hn::Xor(found(low_[swap][0], digit0),
                        hn::Xor(found(low_[swap][1], digit1), found(low_[swap][2], digit2)));
            places[swap] = hn::Or(low, hn::ShiftLeft<8>(found(high_[swap], digit2)));
        }
        return hn::Or(places[0], hn::ShiftLeft<16>(places[1]));
    }

    static HWY_INLINE V chosen(V both, V seed) {
        const auto swapped = hn::TestBit(seed, constant(kJointSwapBit));
        return hn::IfThenElse(swapped, hn::ShiftRight<16>(both), both);
    }

private:
    using ByteVector = hn::Vec<Bytes>;

    static HWY_INLINE V found(ByteVector table, V digits) {
        return hn::BitCast(kWords, lookUpBytes(table, hn::BitCast(Bytes(), digits)));
    }

    ByteVector low_[2][3], high_[2];
};

/// jointPlace, its low byte in opposite order.
class JointPlaces {
public:
    explicit JointPlaces(const JointDigits& digits) : orders_(digits) {}

    /// Of the low 12 bits of `index`; above bit 11 anything. What the last vector of indices gave
    /// is kept, since those of a coherent batch are all the same.
    HWY_INLINE V find(V seed, V index) {
        if (!same(index, index_)) {
            index_ = index;
            both_ = orders_.both(index);
        }
        return orders_.chosen(both_, seed);
    }

private:
    std::conditional_t<(hn::MaxLanes(kWords) >= 8), WideJointOrders, NarrowJointOrders> orders_;
    V index_ = hn::Zero(kWords), both_ = hn::Zero(kWords);
};

HWY_INLINE V jointOffsetOf(V seed, V sampleid, V groupStart, V place) {
    const V shifted = hn::And(hn::Xor(place, seed), constant(kGroupSize - 1));
    return hn::Add(offsetOf(hn::Add(seed, blockStep(sampleid)), groupStart), shifted);
}

/// jointOffset without splits.
class JointOrder {
public:
    static constexpr uint32_t end = kStratifiedSamples;

    explicit JointOrder(const JointDigits& digits) : places_(digits) {}

    HWY_INLINE V offset(V seed, V sampleid) {
        const V place = places_.find(seed, sampleid);
        return jointOffsetOf(seed, sampleid, groupStartOf(place), place);
    }

private:
    JointPlaces places_;
};

/// jointOffset under splits by more than 1.
class SplitJointOrder {
public:
    const uint32_t end;

    SplitJointOrder(const JointDigits& digits, unsigned split)
        : end(jointStratifiedSamples(split)), places_(digits), split_(split),
          evenPartLog2_(static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(split))) {}

    HWY_INLINE V offset(V seed, V sampleid) {
        V visit, branch;
        divide(hn::Min(sampleid, constant(kStratifiedSamples)), split_, visit, branch);
        const V mask = jointOrderMask(visit);
        const V found = places_.find(seed, hn::And(visit, mask));
        const V ordered = hn::Or(groupStartOf(found), reversedByte(found));
        const V place = hn::Or(hn::AndNot(mask, visit), ordered);
        const V index = hn::Add(hn::Mul(place, constant(split_)), jointBranch(seed, visit, branch));
        return jointOffsetOf(seed, index, groupStartOf(index), reversedByte(index));
    }

private:
    static HWY_INLINE V reversedByte(V x) { return hn::ShiftRight<24>(reverseLowByte(x)); }

    /// Exact for numbers below 2^18: (x + 0.5) / divisor is at least 0.5 / divisor away from any
    /// integer, and its two roundings, of less than 2^-23 of it in all, move it by less.
    static HWY_INLINE void divide(V x, uint32_t divisor, V& quotient, V& remainder) {
        const hn::RebindToSigned<Words> integers;
        const F middle =
            hn::Add(hn::ConvertTo(kFloats, hn::BitCast(integers, x)), hn::Set(kFloats, 0.5f));
        const F ratio = hn::Mul(middle, hn::Set(kFloats, 1.0f / static_cast<float>(divisor)));
        quotient = hn::BitCast(kWords, hn::ConvertTo(integers, ratio));
        remainder = hn::Sub(x, hn::Mul(quotient, constant(divisor)));
    }

    template <int kShift>
    static HWY_INLINE V orShifted(V x) {
        return hn::Or(x, hn::ShiftRight<kShift>(x));
    }

    HWY_INLINE V jointOrderMask(V visit) const {
        V differing = hn::Xor(visit, constant(end / split_));
        differing = orShifted<1>(orShifted<2>(orShifted<4>(orShifted<8>(differing))));
        return hn::And(hn::ShiftRight<1>(differing), constant(kTableSize - 1));
    }

    HWY_INLINE V jointBranch(V seed, V visit, V branch) const {
        const uint32_t odd = split_ >> evenPartLog2_;
        const V lowBits = constant((1u << evenPartLog2_) - 1);
        const V golden = constant(detail::kGolden);
        const V hash = mixBits(hn::Add(seed, hn::Mul(visit, golden)));
        const V run = hn::ShiftRightSame(branch, evenPartLog2_);
        V newRun = run; // 0
        if (odd > 1) {
            const V spread =
                hn::Add(hn::Shl(run, hn::And(hash, constant(7))), scaleToRange(hash, odd));
            V quotient;
            divide(spread, odd, quotient, newRun);
        }
        const V ownHash = hn::Add(hash, hn::Mul(run, golden));
        const V shuffled = reversedByte(shuffledPlace(ownHash, hn::And(branch, lowBits)));
        return hn::Or(hn::ShiftLeftSame(newRun, evenPartLog2_), hn::And(shuffled, lowBits));
    }

    JointPlaces places_;
    uint32_t split_;
    int evenPartLog2_;
};

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#endif
