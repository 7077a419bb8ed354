// SPDX-License-Identifier: Apache-2.0
//
// Vectors of words, and what the vector code of several files does with them. Included once for
// each target that Highway compiles a file for.
//
// Each function here has the name of the scalar function whose bits it computes.

#if defined(WELLSTRAT_BATCH_VECTOR_WORDS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_VECTOR_WORDS_H
#undef WELLSTRAT_BATCH_VECTOR_WORDS_H
#else
#define WELLSTRAT_BATCH_VECTOR_WORDS_H
#endif

#include "wellstrat/domain.h"
#include "wellstrat/hash.h"

#include "hwy/highway.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<uint32_t>;
using Bytes = hn::Repartition<uint8_t, Words>;
using Floats = hn::RebindToFloat<Words>;
using Points = hn::Repartition<uint64_t, Words>;
using V = hn::Vec<Words>;
using F = hn::Vec<Floats>;
using P = hn::Vec<Points>;

constexpr Words kWords;
constexpr Floats kFloats;
constexpr Points kPoints;

constexpr std::size_t kLanes = hn::MaxLanes(kWords);

HWY_INLINE V constant(uint32_t value) { return hn::Set(kWords, value); }

template <int kShift>
HWY_INLINE V xorShifted(V x) {
    return hn::Xor(x, hn::ShiftRight<kShift>(x));
}

/// table[indices[i]] for each byte, within 16 bytes; 0 where bit 7 of an index is set. Others are
/// below 16.
template <typename Table, typename Indices>
HWY_INLINE Indices lookUpBytes(Table table, Indices indices) {
#if HWY_TARGET == HWY_WASM
    // Highway's takes byte after byte (docs/decisions/0030-webassembly.md).
    return Indices{wasm_i8x16_swizzle(table.raw, indices.raw)};
#else
    return hn::TableLookupBytesOr0(table, indices);
#endif
}

/// Whether all words are the same.
HWY_INLINE bool same(V a, V b) {
#if HWY_TARGET == HWY_WASM
    return !wasm_v128_any_true(hn::Xor(a, b).raw); // one instruction where others take four
#else
    return hn::AllTrue(kWords, hn::Eq(a, b));
#endif
}

/// The rounds of mixBits and of permuteBits.
HWY_INLINE V mixBits(V x, V multiplier) {
    x = hn::Mul(xorShifted<16>(x), constant(detail::kFirstMultiplier));
    return xorShifted<15>(hn::Mul(xorShifted<15>(x), multiplier));
}

HWY_INLINE V mixBits(V x) { return mixBits(x, constant(detail::kSecondMultiplier)); }

/// v * 2^-24, v below 2^24.
HWY_INLINE F scaledFloat(V v) {
    const hn::RebindToSigned<Words> integers;
    return hn::Mul(hn::ConvertTo(kFloats, hn::BitCast(integers, v)), hn::Set(kFloats, 0x1p-24f));
}

HWY_INLINE F toUnitFloat(V v) { return scaledFloat(hn::ShiftRight<8>(v)); }

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
    std::size_t i = 0;
    for (; i + kLanes <= n; i += kLanes) function(contexts + i, results + i);
    if (i == n) return;
    SampleCtx someContexts[kLanes] = {};
    Result someResults[kLanes];
    const std::size_t rest = n - i;
    for (std::size_t k = 0; k < rest; ++k) someContexts[k] = contexts[i + k];
    function(someContexts, someResults);
    for (std::size_t k = 0; k < rest; ++k) results[i + k] = someResults[k];
}

/// How many vectors are a block.
constexpr std::size_t kBlockVectors = 8;

/// The same by blocks: calls function(vectors, contexts, results) for up to kVectors whole vectors
/// at a time. At one place, since all of a function is inlined.
template <std::size_t kVectors, typename Result, typename Function>
HWY_INLINE void forBlocks(std::size_t n, const SampleCtx* contexts, Result* results,
                          Function function) {
    SampleCtx someContexts[kLanes];
    Result someResults[kLanes];
    for (std::size_t i = 0; i < n;) {
        const std::size_t whole = std::min((n - i) / kLanes, kVectors);
        const bool isRest = whole == 0;
        if (isRest) {
            std::fill(std::copy(contexts + i, contexts + n, someContexts), someContexts + kLanes,
                      SampleCtx{});
        }
        function(isRest ? 1 : whole, isRest ? someContexts : contexts + i,
                 isRest ? someResults : results + i);
        if (isRest) std::copy_n(someResults, n - i, results + i);
        i += isRest ? n - i : whole * kLanes;
    }
}

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#endif
