// SPDX-License-Identifier: Apache-2.0
//
// What vector code makes of the words of tables. Included once for each target, as vector_words.h.
//
// Each function here has the name of the scalar function whose bits it computes.

#if defined(WELLSTRAT_BATCH_TABLE_WORDS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_TABLE_WORDS_H
#undef WELLSTRAT_BATCH_TABLE_WORDS_H
#else
#define WELLSTRAT_BATCH_TABLE_WORDS_H
#endif

#include "batch/vector_words.h"

#include "wellstrat/lookup.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

/// Words of 64 bits in the order of memory: half of them in each vector. Of points, x and y in
/// turn.
struct Halves {
    V lower, upper;
};

/// shiftXY is the seed times this.
constexpr uint64_t kShiftMultiplier = stream1::shiftXY(1);
static_assert(stream1::shiftXY(3) == 3 * kShiftMultiplier, "the seed times a constant");

#if HWY_TARGET == HWY_WASM

// Highway multiplies all 64 bits of both factors, which engines do in ten instructions
// (docs/decisions/0030-webassembly.md).

/// The words times a constant, in 64 bits. The constant is hidden from compilers, which would make
/// it one of 64 bits.
HWY_INLINE Halves products(V x, uint32_t factor) {
    v128_t factors = wasm_i32x4_splat(static_cast<int32_t>(factor));
    __asm__ volatile("" : "+r"(factors));
    return {V{wasm_u64x2_extmul_low_u32x4(x.raw, factors)},
            V{wasm_u64x2_extmul_high_u32x4(x.raw, factors)}};
}

HWY_INLINE Halves shiftXY(V seed) {
    const Halves lower = products(seed, static_cast<uint32_t>(kShiftMultiplier));
    const V zero = hn::Zero(kWords);
    const V upper = hn::Mul(seed, constant(static_cast<uint32_t>(kShiftMultiplier >> 32)));
    return {hn::Add(lower.lower, hn::InterleaveLower(kWords, zero, upper)),
            hn::Add(lower.upper, hn::InterleaveUpper(kWords, zero, upper))};
}

HWY_INLINE Halves tableXY(P lower, P upper) {
    const V words = hn::ConcatEven(kWords, hn::BitCast(kWords, upper), hn::BitCast(kWords, lower));
    return products(words, kPairMultiplier);
}

#else

HWY_INLINE V shiftXY(P seed) {
    const V words = hn::BitCast(kWords, seed);
    const P lower = hn::MulEven(words, constant(static_cast<uint32_t>(kShiftMultiplier)));
    const P upper = hn::MulEven(words, constant(static_cast<uint32_t>(kShiftMultiplier >> 32)));
    return hn::BitCast(kWords, hn::Add(lower, hn::ShiftLeft<32>(upper)));
}

HWY_INLINE Halves shiftXY(V seed) {
    return {shiftXY(hn::PromoteTo(kPoints, hn::LowerHalf(seed))),
            shiftXY(hn::PromoteTo(kPoints, hn::UpperHalf(hn::Half<Words>(), seed)))};
}

HWY_INLINE V tableXY(P words) {
    return hn::BitCast(kWords, hn::MulEven(hn::BitCast(kWords, words), constant(kPairMultiplier)));
}

/// Of the words in the lower halves of 64 bits each.
HWY_INLINE Halves tableXY(P lower, P upper) { return {tableXY(lower), tableXY(upper)}; }

#endif

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#endif
