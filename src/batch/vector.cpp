// SPDX-License-Identifier: Apache-2.0
//
// The batch functions in vector code. Highway compiles this file once for each instruction set of
// the processor family; only its headers are used, so programs need no Highway at run time.
//
// Each function here has the name of the scalar function whose bits it computes.

#include "batch/kernels.h"
#include "batch/vector_targets.h"

#include "wellstrat/lookup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/vector.cpp"
#include "hwy/foreach_target.h"

#include "batch/blue_vector.h"
#include "batch/sequence_vector.h"
#include "batch/table_orders.h"
#include "batch/table_words.h"

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

/// Puts random samples in the place of those from sample `end` on, in n / kLanes vectors of
/// samples, of which `largest` has the largest sampleids.
template <typename Sample>
HWY_INLINE void replaceBeyond(uint32_t end, V largest, std::size_t n, const SampleCtx* contexts,
                              Sample* xis) {
    if (HWY_LIKELY(hn::AllFalse(kWords, hn::Gt(largest, constant(end - 1))))) return;
    for (std::size_t i = 0; i < n; i += kLanes) {
        V patternid, sampleid;
        load(contexts + i, patternid, sampleid);
        Sample random[kLanes];
        storeRandom(patternid, sampleid, random);
        for (std::size_t k = 0; k < kLanes; ++k) {
            if (contexts[i + k].sampleid >= end) xis[i + k] = random[k];
        }
    }
}

/// Draws `vectors` vectors of samples, kBlockVectors at most. First all places are found and then
/// all points loaded, so that no load waits for the arithmetic of its own sample. If their number
/// is a constant, a batch of 16 takes a tenth less time.
template <typename Count, typename Order, typename Sample>
HWY_INLINE void drawBlock(Count vectors, const uint32_t* words, const SampleCtx* contexts,
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
    replaceBeyond(order.end, largest, n, contexts, xis);
}

template <typename Order, typename Sample>
HWY_INLINE void drawInOrder(std::size_t n, const uint32_t* words, const SampleCtx* contexts,
                            Order order, Sample* xis) {
    forBlocks<kBlockVectors>(
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
    constexpr bool isWide = kLanes >= 8; // 16 samples are one or two vectors
    ShuffledOrder order;
    if (isWide && n == kLanes) {
        drawBlock(std::integral_constant<std::size_t, 1>(), words, contexts, order, xis);
    } else if (isWide && n == 2 * kLanes) {
        drawBlock(std::integral_constant<std::size_t, 2>(), words, contexts, order, xis);
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
    drawSequence<float>,
    drawSequence<Float2>,
    drawSequence<Float3>,
    drawSequence<uint32_t>,
    drawSequence<Bits2>,
    drawSequence<Bits3>,
    drawBlue<float>,
    drawBlue<Float2>,
    drawBlue<Float3>,
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
