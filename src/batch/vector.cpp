// SPDX-License-Identifier: Apache-2.0
//
// The batch functions in vector code. Highway compiles this file once for each instruction set of
// the processor family; only its headers are used, so programs need no Highway at run time.
//
// Each function here has the name of the scalar function whose bits it computes.

#include "batch/joint_digits.h"
#include "batch/kernels.h"
#include "batch/vector_targets.h"

#include "wellstrat/lookup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/vector.cpp"
#include "hwy/foreach_target.h"

#include "batch/blue_vector.h"
#include "batch/sequence_vector.h"
#include "batch/table_words.h"
#include "batch/vector_words.h"

#include <type_traits>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE V permuteBits(V x, PermutationKey key) {
    return mixBits(hn::Xor(x, constant(key.mask)), constant(key.multiplier));
}

HWY_INLINE V permuteBitsByKey(V x, V key) {
    const V mask = mixBits(hn::Add(key, constant(detail::kGolden)));
    const V word = mixBits(hn::Add(mask, constant(detail::kGolden)));
    return mixBits(hn::Xor(x, mask), hn::Xor(hn::And(word, constant(detail::kKeyedBits)),
                                             constant(detail::kSecondMultiplier)));
}

HWY_INLINE V hashPair(V a, V b) { return mixBits(hn::Add(permuteBitsByKey(b, a), b)); }

HWY_INLINE V derivePattern(V patternid, DerivationKey key) {
    return hn::Mul(hn::Xor(patternid, constant(key.mask)), constant(key.multiplier));
}

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

/// Random samples, as random.h has them.
HWY_INLINE F randomSample(V patternid, V sampleid, Coordinate coordinate) {
    if (coordinate != Coordinate::z) patternid = permuteBits(patternid, randomKey(coordinate));
    return toUnitFloat(hashPair(patternid, sampleid));
}

HWY_INLINE void storeRandom(V patternid, V sampleid, float* xis) {
    hn::StoreU(randomSample(patternid, sampleid, Coordinate::z), kFloats, xis);
}
HWY_INLINE void storeRandom(V patternid, V sampleid, Float2* xis) {
    hn::StoreInterleaved2(randomSample(patternid, sampleid, Coordinate::x),
                          randomSample(patternid, sampleid, Coordinate::y), kFloats,
                          reinterpret_cast<float*>(xis));
}
HWY_INLINE void storeRandom(V patternid, V sampleid, Float3* xis) {
    hn::StoreInterleaved3(randomSample(patternid, sampleid, Coordinate::x),
                          randomSample(patternid, sampleid, Coordinate::y),
                          randomSample(patternid, sampleid, Coordinate::z), kFloats,
                          reinterpret_cast<float*>(xis));
}

/// The words at offsets[0, kLanes / 2), each in the lower half of 64 bits; above it is the next
/// word.
template <typename D>
HWY_INLINE hn::Vec<D> wordsAt(D d, const uint32_t* words, const uint32_t* offsets) {
    constexpr std::size_t count = hn::MaxLanes(D());
    if constexpr (count == 1) {
        const hn::Repartition<uint32_t, D> halves;
        return hn::BitCast(d, hn::LoadU(halves, words + *offsets));
    } else {
        const hn::Half<D> half;
        const auto lower = wordsAt(half, words, offsets);
        return hn::Combine(d, wordsAt(half, words, offsets + count / 2), lower);
    }
}

/// The same for the xy and the z words of points, with each offset loaded once.
template <typename D>
HWY_INLINE void pointsAt(D d, const uint32_t* words, const uint32_t* offsets, hn::Vec<D>& xy,
                         hn::Vec<D>& z) {
    constexpr std::size_t count = hn::MaxLanes(D());
    if constexpr (count == 1) {
        const uint32_t* point = words + *offsets;
        const uint32_t first = 0;
        xy = wordsAt(d, point, &first);
        z = wordsAt(d, point + kTablePoints, &first);
    } else {
        const hn::Half<D> half;
        hn::Vec<hn::Half<D>> lowerXY, lowerZ, upperXY, upperZ;
        pointsAt(half, words, offsets, lowerXY, lowerZ);
        pointsAt(half, words, offsets + count / 2, upperXY, upperZ);
        xy = hn::Combine(d, upperXY, lowerXY);
        z = hn::Combine(d, upperZ, lowerZ);
    }
}

/// What is XORed to points, for a vector of seeds.
class Shifts {
public:
    HWY_INLINE explicit Shifts(V seed) : seed_(seed) {}

    HWY_INLINE Halves xy() const { return shiftXY(seed_); }
    HWY_INLINE V z() const { return hn::Mul(seed_, constant(digitalShift(1, Coordinate::z))); }

private:
    V seed_;
};

/// The same for one pattern.
class PatternShift {
public:
    HWY_INLINE explicit PatternShift(V seed) : xy_(Shifts(seed).xy()), z_(Shifts(seed).z()) {}

    HWY_INLINE Halves xy() const { return xy_; }
    HWY_INLINE V z() const { return z_; }

private:
    Halves xy_;
    V z_;
};

/// One vector of samples: of the points at `offsets`, shifted. By single loads: gather instructions
/// take longer (docs/decisions/0013-cheaper-draws.md).
template <typename Shift>
class Samples {
public:
    HWY_INLINE Samples(const uint32_t* words, Shift shift, const uint32_t* offsets)
        : words_(words), shift_(shift), lower_(offsets), upper_(offsets + kLanes / 2) {}

    HWY_INLINE void store(float* xis) const {
        const uint32_t* z = words_ + kTablePoints;
        hn::StoreU(zOf(wordsAt(kPoints, z, lower_), wordsAt(kPoints, z, upper_)), kFloats, xis);
    }

    HWY_INLINE void store(Float2* xis) const {
        float* floats = reinterpret_cast<float*>(xis);
        const Halves xy = xyOf(wordsAt(kPoints, words_, lower_), wordsAt(kPoints, words_, upper_));
        hn::StoreU(toUnitFloat(xy.lower), kFloats, floats);
        hn::StoreU(toUnitFloat(xy.upper), kFloats, floats + kLanes);
    }

    HWY_INLINE void store(Float3* xis) const {
        P lowerXY, lowerZ, upperXY, upperZ;
        pointsAt(kPoints, words_, lower_, lowerXY, lowerZ);
        pointsAt(kPoints, words_, upper_, upperXY, upperZ);
        const Halves xy = xyOf(lowerXY, upperXY);
        const F x = toUnitFloat(hn::ConcatEven(kWords, xy.upper, xy.lower));
        const F y = toUnitFloat(hn::ConcatOdd(kWords, xy.upper, xy.lower));
        hn::StoreInterleaved3(x, y, zOf(lowerZ, upperZ), kFloats, reinterpret_cast<float*>(xis));
    }

private:
    /// x and y of the points in turn, as memory has them.
    HWY_INLINE Halves xyOf(P lower, P upper) const {
        const Halves words = tableXY(lower, upper), shift = shift_.xy();
        return {hn::Xor(words.lower, shift.lower), hn::Xor(words.upper, shift.upper)};
    }

    HWY_INLINE F zOf(P lower, P upper) const {
        const V words =
            hn::ConcatEven(kWords, hn::BitCast(kWords, upper), hn::BitCast(kWords, lower));
        return toUnitFloat(hn::Xor(words, shift_.z()));
    }

    const uint32_t* words_;
    Shift shift_;
    const uint32_t *lower_, *upper_;
};

/// Puts random samples in the place of those of one vector from sample `end` on.
template <typename Sample>
HWY_INLINE void replaceBeyond(uint32_t end, const SampleCtx* contexts, Sample* xis) {
    V patternid, sampleid;
    load(contexts, patternid, sampleid);
    Sample random[kLanes];
    storeRandom(patternid, sampleid, random);
    for (std::size_t i = 0; i < kLanes; ++i) {
        if (contexts[i].sampleid >= end) xis[i] = random[i];
    }
}

/// Draws `vectors` vectors of samples, kBlockVectors at most. First all places are found and then
/// all points loaded, so that no load waits for the arithmetic of its own sample.
template <typename Order, typename Sample>
HWY_INLINE void drawBlock(std::size_t vectors, const uint32_t* words, const SampleCtx* contexts,
                          Order& order, Sample* xis) {
    HWY_ALIGN uint32_t seeds[kBlockVectors * kLanes];
    HWY_ALIGN uint32_t offsets[kBlockVectors * kLanes];
    const std::size_t n = vectors * kLanes;
    V largest = hn::Zero(kWords);
    for (std::size_t i = 0; i < n; i += kLanes) {
        V patternid, sampleid;
        load(contexts + i, patternid, sampleid);
        const V seed = patternSeed(patternid);
        hn::Store(seed, kWords, seeds + i);
        hn::Store(order.offset(seed, sampleid), kWords, offsets + i);
        largest = hn::Max(largest, sampleid);
    }
    for (std::size_t i = 0; i < n; i += kLanes) {
        Samples(words, Shifts(hn::Load(kWords, seeds + i)), offsets + i).store(xis + i);
    }
    if (HWY_LIKELY(hn::AllFalse(kWords, hn::Gt(largest, constant(order.end - 1))))) return;
    for (std::size_t i = 0; i < n; i += kLanes) replaceBeyond(order.end, contexts + i, xis + i);
}

/// The same for one vector, which by itself need not go through the loops of a block: a batch of 16
/// takes a tenth less time on AVX-512.
template <typename Order, typename Sample>
HWY_INLINE void drawVector(const uint32_t* words, const SampleCtx* contexts, Order& order,
                           Sample* xis) {
    V patternid, sampleid;
    load(contexts, patternid, sampleid);
    const V seed = patternSeed(patternid);
    HWY_ALIGN uint32_t offsets[kLanes];
    hn::Store(order.offset(seed, sampleid), kWords, offsets);
    Samples(words, Shifts(seed), offsets).store(xis);
    if (HWY_LIKELY(hn::AllFalse(kWords, hn::Gt(sampleid, constant(order.end - 1))))) return;
    replaceBeyond(order.end, contexts, xis);
}

template <typename Order, typename Sample>
HWY_INLINE void drawInOrder(std::size_t n, const uint32_t* words, const SampleCtx* contexts,
                            Order order, Sample* xis) {
    forBlocks(
        n, contexts, xis,
        [&](std::size_t vectors, const SampleCtx* some, Sample* results)
            __attribute__((always_inline)) { drawBlock(vectors, words, some, order, results); });
}

template <typename Sample>
void drawJoint(std::size_t n, const uint32_t* words, const SampleCtx* contexts, unsigned slot,
               unsigned split, Sample* xis) {
    const JointDigits& digits = kJointDigits[slot];
    if (split == 1) return drawInOrder(n, words, contexts, JointOrder(digits), xis);
    drawInOrder(n, words, contexts, SplitJointOrder(digits, split), xis);
}

template <typename Sample>
void draw(std::size_t n, const uint32_t* words, SampleCtx* contexts, unsigned step, Sample* xis) {
    ShuffledOrder order;
    if (n == kLanes) {
        drawVector(words, contexts, order, xis);
    } else {
        drawInOrder(n, words, contexts, order, xis);
    }
    for (std::size_t i = 0; step != 0 && i < n; ++i) contexts[i].sampleid += step;
}

/// What the pattern alone decides is computed once. By blocks, as drawBlock.
template <typename Sample>
void drawRun(std::size_t n, const uint32_t* words, uint32_t patternid, uint32_t first,
             Sample* xis) {
    constexpr std::size_t kBlock = kBlockVectors * kLanes;
    const uint32_t seed = stream1::patternSeed(patternid);
    const V seeds = constant(seed);
    const PatternShift shift(seeds);
    for (std::size_t i = 0; i < n;) {
        const auto begin = static_cast<uint32_t>(first + i);
        const std::size_t inTable = kTableSize - begin % kTableSize;
        const std::size_t count = std::min({n - i, inTable, kBlock});
        const V table = constant(tableOfBlock(seed, begin / kTableSize) * kGroupSize);
        HWY_ALIGN uint32_t offsets[kBlock];
        V sampleid = hn::Iota(kWords, begin);
        for (std::size_t k = 0; k < count; k += kLanes) {
            const V row = hn::Mul(groupStartOf(sampleid), constant(kTableCount));
            const V place = shuffledPlace(seeds, sampleid);
            hn::Store(hn::Add(hn::Add(row, table), place), kWords, offsets + k);
            sampleid = hn::Add(sampleid, constant(kLanes));
        }
        for (std::size_t k = 0; k < count; k += kLanes) {
            const Samples samples(words, shift, offsets + k);
            if (HWY_LIKELY(k + kLanes <= count)) {
                samples.store(xis + i + k);
            } else {
                Sample rest[kLanes];
                samples.store(rest);
                std::copy_n(rest, count - k, xis + i + k);
            }
        }
        i += count;
    }
}

void newDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                     unsigned newnumsamples, SampleCtx* children) {
    const DerivationKey key = derivationKey(scramble);
    forVectors(n, parents, children, [&](const SampleCtx* parent, SampleCtx* child) {
        V patternid, sampleid;
        load(parent, patternid, sampleid);
        store(derivePattern(patternid, key), hn::Mul(sampleid, constant(newnumsamples)), child);
    });
}

void newDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                       unsigned newsampleid, SampleCtx* children) {
    const DerivationKey key = derivationKey(scramble);
    forVectors(n, parents, children, [&](const SampleCtx* parent, SampleCtx* child) {
        V patternid, sampleid;
        load(parent, patternid, sampleid);
        const V domain = derivePattern(patternid, key);
        store(permuteBitsByKey(domain, hn::Xor(sampleid, constant(detail::kDistribKey))),
              constant(newsampleid), child);
    });
}

void hashToRandom(std::size_t n, const SampleCtx* contexts, float* xis) {
    forVectors(n, contexts, xis, [](const SampleCtx* sc, float* results) {
        V a, b;
        load(sc, a, b);
        hn::StoreU(toUnitFloat(hashPair(a, b)), kFloats, results);
    });
}

} // namespace

extern const Kernels kKernels;
const Kernels kKernels = {
    hwy::TargetName(HWY_TARGET),
    draw<float>,
    draw<Float2>,
    draw<Float3>,
    drawRun<float>,
    drawRun<Float2>,
    drawRun<Float3>,
    drawJoint<float>,
    drawJoint<Float2>,
    drawJoint<Float3>,
    drawSequence1D,
    drawSequence2D,
    drawSequence3D,
    drawSequenceBits1D,
    drawSequenceBits2D,
    drawSequenceBits3D,
    drawBlue1D,
    drawBlue2D,
    drawBlue3D,
    newDomainsSplit,
    newDomainsDistrib,
    newBlueDomainsSplit,
    newBlueDomainsDistrib,
    hashToRandom,
};

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE

namespace wellstrat {
inline namespace stream1 {
namespace batch {

// Highway's own dispatch needs its shared library for the question which targets the processor has.
// Compilers answer that too.

const Kernels* const* vectorKernels() {
    struct List {
        const Kernels* kernels[8] = {};

        List() {
            unsigned count = 0;
#if HWY_ARCH_X86
            __builtin_cpu_init();
#if HWY_TARGETS & HWY_AVX3
            if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                __builtin_cpu_supports("avx512vl")) {
                kernels[count++] = &N_AVX3::kKernels;
            }
#endif
#if HWY_TARGETS & HWY_AVX2
            if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                __builtin_cpu_supports("bmi2")) {
                kernels[count++] = &N_AVX2::kKernels;
            }
#endif
#if HWY_TARGETS & HWY_SSE4
            if (__builtin_cpu_supports("sse4.2")) kernels[count++] = &N_SSE4::kKernels;
#endif
#elif HWY_STATIC_TARGET != HWY_SCALAR && HWY_STATIC_TARGET != HWY_EMU128
            kernels[count++] = &HWY_STATIC_DISPATCH(kKernels);
#endif
            (void)count;
        }
    };
    static const List list;
    return list.kernels;
}

} // namespace batch
} // namespace stream1
} // namespace wellstrat

#endif
