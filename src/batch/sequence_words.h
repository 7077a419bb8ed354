// SPDX-License-Identifier: Apache-2.0
//
// The functions of sequence.h on vectors, for all generators of computed points. Included once for
// each target, as vector_words.h.
//
// Each function here has the name of the scalar function whose bits it computes.

#if defined(WELLSTRAT_BATCH_SEQUENCE_WORDS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_SEQUENCE_WORDS_H
#undef WELLSTRAT_BATCH_SEQUENCE_WORDS_H
#else
#define WELLSTRAT_BATCH_SEQUENCE_WORDS_H
#endif

#include "batch/vector_words.h"

#include "wellstrat/sequence.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

/// By nibbles, of the bytes in opposite order.
HWY_INLINE V reverseBits(V x) {
    alignas(16) static constexpr uint8_t kBytes[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                       11, 10, 9, 8, 15, 14, 13, 12};
    alignas(16) static constexpr uint8_t kNibbles[16] = {0, 8, 4, 12, 2, 10, 6, 14,
                                                         1, 9, 5, 13, 3, 11, 7, 15};
    constexpr Bytes bytes;
    const auto table = hn::LoadDup128(bytes, kNibbles);
    const auto swapped = hn::TableLookupBytes(hn::BitCast(bytes, x), hn::LoadDup128(bytes, kBytes));
    const V nibble = constant(0x0f0f0f0fu);
    const V low = hn::And(hn::BitCast(kWords, swapped), nibble);
    const V high = hn::And(hn::ShiftRight<4>(hn::BitCast(kWords, swapped)), nibble);
    const auto reversed = [&](V nibbles) {
        return hn::BitCast(kWords, hn::TableLookupBytes(table, hn::BitCast(bytes, nibbles)));
    };
    return hn::Or(hn::ShiftLeft<4>(reversed(low)), reversed(high));
}

/// x ^ ((x >> kShift) & mask)
template <int kShift>
HWY_INLINE V xorMasked(V x, uint32_t mask) {
    return hn::Xor(x, hn::And(hn::ShiftRight<kShift>(x), constant(mask)));
}

HWY_INLINE V pascalTimes(V index) {
    index = xorMasked<1>(index, 0x55555555u);
    index = xorMasked<2>(index, 0x33333333u);
    index = xorMasked<4>(index, 0x0f0f0f0fu);
    index = xorMasked<8>(index, 0x00ff00ffu);
    return xorShifted<16>(index);
}

HWY_INLINE V trinomialTimes(V index) {
    index = xorMasked<16>(xorMasked<8>(index, 0x00ffff00u), 0x000000ffu);
    index = xorMasked<8>(xorMasked<4>(index, 0x0ff00ff0u), 0x000f000fu);
    index = xorMasked<4>(xorMasked<2>(index, 0x3c3c3c3cu), 0x03030303u);
    index = xorMasked<2>(xorMasked<1>(index, 0x66666666u), 0x11111111u);
    return xorMasked<1>(index, 0x55555555u);
}

HWY_INLINE V owenHash(V digits, V key) {
    const V upper = hn::ShiftRight<16>(key);
    digits = hn::Add(digits, hn::Xor(key, upper));
    digits = hn::Mul(digits, hn::Or(upper, constant(1)));
    digits = hn::Xor(digits, hn::Mul(digits, constant(0x3d20adeau)));
    digits = hn::Add(digits, hn::ShiftRight<8>(key));
    return hn::Xor(digits, hn::Mul(digits, constant(0x05526c56u)));
}

HWY_INLINE V sequenceSeed(V patternid) {
    return mixBits(hn::Xor(patternid, constant(detail::kSequenceKey)));
}

HWY_INLINE V scramblingKey(V seed, Coordinate coordinate) {
    return hn::Mul(seed, constant(stream1::scramblingKey(1, coordinate)));
}

HWY_INLINE V shuffleKey(V seed) { return hn::Mul(seed, constant(stream1::shuffleKey(1))); }

/// PointDigits of a vector of points.
struct PointVectors {
    V x, y, z;
};

HWY_INLINE PointVectors sequenceDigits(V index) {
    return {index, pascalTimes(index), trinomialTimes(index)};
}

HWY_INLINE F scrambledSample(V digits, V seed, Coordinate coordinate) {
    return toUnitFloat(reverseBits(owenHash(digits, scramblingKey(seed, coordinate))));
}

/// scrambledSampleZ, XY and XYZ of a vector of points, into xis[0, kLanes).
HWY_INLINE void storeScrambled(PointVectors point, V seed, float* xis) {
    hn::StoreU(scrambledSample(point.z, seed, Coordinate::z), kFloats, xis);
}
HWY_INLINE void storeScrambled(PointVectors point, V seed, Float2* xis) {
    hn::StoreInterleaved2(scrambledSample(point.x, seed, Coordinate::x),
                          scrambledSample(point.y, seed, Coordinate::y), kFloats,
                          reinterpret_cast<float*>(xis));
}
HWY_INLINE void storeScrambled(PointVectors point, V seed, Float3* xis) {
    hn::StoreInterleaved3(scrambledSample(point.x, seed, Coordinate::x),
                          scrambledSample(point.y, seed, Coordinate::y),
                          scrambledSample(point.z, seed, Coordinate::z), kFloats,
                          reinterpret_cast<float*>(xis));
}

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#endif
