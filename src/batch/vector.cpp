// SPDX-License-Identifier: Apache-2.0
//
// The batch functions in vector code. Highway compiles this file once for each instruction set of
// the processor family; only its headers are used, so programs need no Highway at run time.
//
// Each function here has the name of the scalar function whose bits it computes.

#include "batch/kernels.h"

#include "wellstrat/lookup.h"

// Left out: registers of no fixed size, and what gains nothing over the next target.
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/vector.cpp"
#include "hwy/foreach_target.h"

#include "hwy/highway.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
namespace batch {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<uint32_t>;
using Bytes = hn::Repartition<uint8_t, Words>;
using Floats = hn::RebindToFloat<Words>;
using V = hn::Vec<Words>;
using F = hn::Vec<Floats>;

constexpr Words kWords;
constexpr Floats kFloats;

HWY_INLINE V constant(uint32_t value) { return hn::Set(kWords, value); }

template <int kShift>
HWY_INLINE V xorShifted(V x) {
    return hn::Xor(x, hn::ShiftRight<kShift>(x));
}

/// The rounds of mixBits and of permuteBits.
HWY_INLINE V mixBits(V x, V multiplier) {
    x = hn::Mul(xorShifted<16>(x), constant(detail::kFirstMultiplier));
    return xorShifted<15>(hn::Mul(xorShifted<15>(x), multiplier));
}

HWY_INLINE V mixBits(V x) { return mixBits(x, constant(detail::kSecondMultiplier)); }

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

HWY_INLINE V reverseLowByte(V x) {
    alignas(16) static constexpr uint8_t kReversed[16] = {0, 8, 4, 12, 2, 10, 6, 14,
                                                          1, 9, 5, 13, 3, 11, 7, 15};
    constexpr Bytes bytes;
    const auto table = hn::LoadDup128(bytes, kReversed);
    const V nibble = constant(15);
    const auto reversed = [&](V nibbles) {
        return hn::BitCast(kWords, hn::TableLookupBytes(table, hn::BitCast(bytes, nibbles)));
    };
    const V low = reversed(hn::And(x, nibble));
    const V high = reversed(hn::And(hn::ShiftRight<4>(x), nibble));
    return hn::Or(hn::ShiftLeft<28>(low), hn::ShiftLeft<24>(high));
}

HWY_INLINE V patternSeed(V patternid) {
    return mixBits(hn::Add(patternid, constant(detail::kGolden)));
}

HWY_INLINE V shuffledPlace(V seed, V sampleid) {
    V r = hn::Or(reverseLowByte(sampleid), hn::And(sampleid, constant(~(kGroupSize - 1))));
    r = hn::Add(r, seed);
    r = hn::Mul(r, hn::Add(hn::Add(seed, seed), constant(1)));
    r = hn::Xor(r, hn::Mul(r, constant(0x3d20adeau)));
    r = hn::Xor(r, hn::Mul(r, constant(0x05526c56u)));
    return hn::ShiftRight<24>(r);
}

HWY_INLINE V sampleOffset(V seed, V sampleid) {
    const V block = hn::ShiftRight<kTableSizeLog2>(sampleid);
    const V word = hn::Add(seed, hn::Mul(block, constant(kBlockStep)));
    const V table = hn::ShiftRight<23>(hn::Mul(hn::ShiftRight<9>(word), constant(kTableCount)));
    const V groupStart = hn::And(sampleid, constant(kTableSize - kGroupSize));
    const V row = hn::Add(hn::Mul(groupStart, constant(kTableCount)), hn::ShiftLeft<8>(table));
    return hn::Add(row, shuffledPlace(seed, sampleid));
}

HWY_INLINE V gather(const uint32_t* words, V offset) {
    const hn::RebindToSigned<Words> indices;
    return hn::GatherIndex(kWords, words, hn::BitCast(indices, offset));
}

HWY_INLINE V leafBits(V xyWord, V offset) {
    const V odd = hn::Add(hn::Add(offset, offset), constant(1));
    return hn::ShiftRight<12>(hn::Mul(xyWord, odd));
}

HWY_INLINE F toUnitFloat(V v) {
    const hn::RebindToSigned<Words> integers;
    const auto integer = hn::BitCast(integers, hn::ShiftRight<8>(v));
    return hn::Mul(hn::ConvertTo(kFloats, integer), hn::Set(kFloats, 0x1p-24f));
}

HWY_INLINE V shifted(V value, V seed, Coordinate coordinate) {
    return hn::Xor(value, hn::Mul(seed, constant(digitalShift(1, coordinate))));
}

static_assert(digitalShift(1, Coordinate::x) * 3u == digitalShift(3, Coordinate::x),
              "a digital shift is the seed times a constant");

/// `stratified`, or in the lanes beyond the tables the random bits instead.
HWY_INLINE V orRandom(V stratified, V patternid, V sampleid, Coordinate coordinate) {
    const auto beyond = hn::Gt(sampleid, constant(kStratifiedSamples - 1));
    if (HWY_LIKELY(hn::AllFalse(kWords, beyond))) return stratified;
    if (coordinate != Coordinate::z) patternid = permuteBits(patternid, randomKey(coordinate));
    return hn::IfThenElse(beyond, hashPair(patternid, sampleid), stratified);
}

// One vector of samples. Beyond the tables the offset means nothing, but is always inside them.

HWY_INLINE void sampleXY(const uint32_t* words, V patternid, V sampleid, V seed, V offset, F& x,
                         F& y) {
    const V word = gather(words, offset);
    const V leaf = leafBits(word, offset);
    const V tableX = hn::Xor(word, leaf);
    const V tableY = hn::Xor(hn::ShiftLeft<12>(word), leaf);
    x = toUnitFloat(
        orRandom(shifted(tableX, seed, Coordinate::x), patternid, sampleid, Coordinate::x));
    y = toUnitFloat(
        orRandom(shifted(tableY, seed, Coordinate::y), patternid, sampleid, Coordinate::y));
}

HWY_INLINE F sampleZ(const uint32_t* words, V patternid, V sampleid, V seed, V offset) {
    const V value = shifted(gather(words + kTablePoints, offset), seed, Coordinate::z);
    return toUnitFloat(orRandom(value, patternid, sampleid, Coordinate::z));
}

HWY_INLINE void storeSamples(const uint32_t* words, V patternid, V sampleid, float* xis) {
    const V seed = patternSeed(patternid);
    const V offset = sampleOffset(seed, sampleid);
    hn::StoreU(sampleZ(words, patternid, sampleid, seed, offset), kFloats, xis);
}

HWY_INLINE void storeSamples(const uint32_t* words, V patternid, V sampleid, Float2* xis) {
    const V seed = patternSeed(patternid);
    const V offset = sampleOffset(seed, sampleid);
    F x, y;
    sampleXY(words, patternid, sampleid, seed, offset, x, y);
    hn::StoreInterleaved2(x, y, kFloats, reinterpret_cast<float*>(xis));
}

HWY_INLINE void storeSamples(const uint32_t* words, V patternid, V sampleid, Float3* xis) {
    const V seed = patternSeed(patternid);
    const V offset = sampleOffset(seed, sampleid);
    F x, y;
    sampleXY(words, patternid, sampleid, seed, offset, x, y);
    const F z = sampleZ(words, patternid, sampleid, seed, offset);
    hn::StoreInterleaved3(x, y, z, kFloats, reinterpret_cast<float*>(xis));
}

HWY_INLINE void load(const SampleCtx* contexts, V& patternid, V& sampleid) {
    hn::LoadInterleaved2(kWords, reinterpret_cast<const uint32_t*>(contexts), patternid, sampleid);
}

HWY_INLINE void store(V patternid, V sampleid, SampleCtx* contexts) {
    hn::StoreInterleaved2(patternid, sampleid, kWords, reinterpret_cast<uint32_t*>(contexts));
}

/// Calls function(contexts, results) for each whole vector of them, and once for the rest, with
/// copies that fill a vector.
template <typename Context, typename Result, typename Function>
HWY_INLINE void forVectors(std::size_t n, Context* contexts, Result* results, Function function) {
    const std::size_t lanes = hn::Lanes(kWords);
    std::size_t i = 0;
    for (; i + lanes <= n; i += lanes) function(contexts + i, results + i);
    if (i == n) return;
    SampleCtx someContexts[hn::MaxLanes(kWords)] = {};
    Result someResults[hn::MaxLanes(kWords)];
    const std::size_t rest = n - i;
    for (std::size_t k = 0; k < rest; ++k) someContexts[k] = contexts[i + k];
    function(someContexts, someResults);
    for (std::size_t k = 0; k < rest; ++k) results[i + k] = someResults[k];
}

template <typename Sample>
void draw(std::size_t n, const uint32_t* words, SampleCtx* contexts, unsigned step, Sample* xis) {
    forVectors(n, contexts, xis, [&](const SampleCtx* sc, Sample* results) {
        V patternid, sampleid;
        load(sc, patternid, sampleid);
        storeSamples(words, patternid, sampleid, results);
    });
    for (std::size_t i = 0; step != 0 && i < n; ++i) contexts[i].sampleid += step;
}

void newDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                     unsigned newnumsamples, SampleCtx* children) {
    const PermutationKey key = permutationKey(static_cast<unsigned>(scramble));
    forVectors(n, parents, children, [&](const SampleCtx* parent, SampleCtx* child) {
        V patternid, sampleid;
        load(parent, patternid, sampleid);
        store(permuteBits(patternid, key), hn::Mul(sampleid, constant(newnumsamples)), child);
    });
}

void newDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                       unsigned newsampleid, SampleCtx* children) {
    const PermutationKey key = permutationKey(static_cast<unsigned>(scramble));
    forVectors(n, parents, children, [&](const SampleCtx* parent, SampleCtx* child) {
        V patternid, sampleid;
        load(parent, patternid, sampleid);
        const V domain = permuteBits(patternid, key);
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
    hwy::TargetName(HWY_TARGET), draw<float>,  draw<Float2>, draw<Float3>, newDomainsSplit,
    newDomainsDistrib,           hashToRandom,
};

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE

namespace wellstrat {
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
} // namespace wellstrat

#endif
