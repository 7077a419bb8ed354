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

#include "batch/byte_maps.h"
#include "batch/vector_words.h"

#include "wellstrat/sequence.h"

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
HWY_BEFORE_NAMESPACE();
namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

/// Which byte of a word each byte of another one is; kNone: 0.
constexpr uint8_t kNone = 0x80;
template <uint8_t k0, uint8_t k1, uint8_t k2, uint8_t k3>
HWY_INLINE V bytesOf(V x) {
    alignas(16) static constexpr uint8_t kIndices[16] = {
        k0,     k1,     k2,     k3,     k0 + 4,  k1 + 4,  k2 + 4,  k3 + 4,
        k0 + 8, k1 + 8, k2 + 8, k3 + 8, k0 + 12, k1 + 12, k2 + 12, k3 + 12};
    constexpr Bytes bytes;
    return hn::BitCast(kWords, lookUpBytes(hn::BitCast(bytes, x), hn::LoadDup128(bytes, kIndices)));
}

/// The nibbles of all bytes of a vector of words.
struct Nibbles {
    V low, high;
};
HWY_INLINE Nibbles nibblesOf(V x) {
    const V nibble = constant(0x0f0f0f0fu);
    return {hn::And(x, nibble), hn::And(hn::ShiftRight<4>(x), nibble)};
}

HWY_INLINE V mapped(const ByteMap& map, Nibbles nibbles) {
    constexpr Bytes bytes;
    const auto low = lookUpBytes(hn::LoadDup128(bytes, map.low), hn::BitCast(bytes, nibbles.low));
    const auto high =
        lookUpBytes(hn::LoadDup128(bytes, map.high), hn::BitCast(bytes, nibbles.high));
    return hn::BitCast(kWords, hn::Xor(low, high));
}

HWY_INLINE V reverseBits(V x) {
    return mapped(kByteMaps.reversed, nibblesOf(bytesOf<3, 2, 1, 0>(x)));
}

/// x ^ ((x >> kShift) & mask)
template <int kShift>
HWY_INLINE V xorMasked(V x, uint32_t mask) {
    return hn::Xor(x, hn::And(hn::ShiftRight<kShift>(x), constant(mask)));
}

/// pascalTimes of words whose bytes have been mapped.
HWY_INLINE V pascalOfBytes(V bytes) { return xorShifted<16>(xorMasked<8>(bytes, 0x00ff00ffu)); }

HWY_INLINE V pascalTimes(V index) {
    return pascalOfBytes(mapped(kByteMaps.pascal, nibblesOf(index)));
}

HWY_INLINE V trinomialTimes(V index) {
    index = xorMasked<16>(xorMasked<8>(index, 0x00ffff00u), 0x000000ffu);
    index = xorMasked<8>(xorMasked<4>(index, 0x0ff00ff0u), 0x000f000fu);
    return mapped(kByteMaps.trinomial, nibblesOf(index));
}

/// What owenHash makes of a key.
struct OwenKey {
    V added, factor;

    HWY_INLINE explicit OwenKey(V key)
        : added(bytesOf<2, 3, 0, 1>(key)), factor(hn::Or(hn::ShiftRight<7>(key), constant(1))) {}
};

HWY_INLINE V owenHash(V digits, const OwenKey& key) {
    digits = hn::Mul(hn::Add(digits, key.added), key.factor);
    return hn::Xor(digits, hn::Mul(digits, hn::Add(digits, digits)));
}

HWY_INLINE V owenHash(V digits, V key) { return owenHash(digits, OwenKey(key)); }

HWY_INLINE V sequenceSeed(V patternid) {
    const V x = hn::Xor(patternid, constant(detail::kSequenceKey));
    return xorShifted<15>(hn::Mul(xorShifted<16>(x), constant(detail::kFirstMultiplier)));
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

/// sequenceDigits of the indices that `hashed` has in opposite order, in their low kDigits bits.
template <int kDigits>
HWY_INLINE PointVectors sequenceDigitsOfReversed(V hashed) {
    static_assert(kDigits == 16 || kDigits == 32);
    const Nibbles nibbles = nibblesOf(kDigits == 16 ? bytesOf<3, 2, kNone, kNone>(hashed)
                                                    : bytesOf<3, 2, 1, 0>(hashed));
    const V index = mapped(kByteMaps.reversed, nibbles);
    const V pascal = mapped(kByteMaps.pascalOfReversed, nibbles);
    if (kDigits == 32) return {index, pascalOfBytes(pascal), trinomialTimes(index)};
    const V upper = xorMasked<8>(xorMasked<4>(index, 0x0ff0u), 0x000fu);
    return {index, xorShifted<8>(pascal), mapped(kByteMaps.trinomial, nibblesOf(upper))};
}

/// The keys of scrambledSample for a vector of seeds.
struct ScramblingKeys {
    OwenKey x, y, z;

    HWY_INLINE explicit ScramblingKeys(V seed)
        : x(scramblingKey(seed, Coordinate::x)), y(scramblingKey(seed, Coordinate::y)),
          z(scramblingKey(seed, Coordinate::z)) {}
};

HWY_INLINE F scrambledSample(V digits, const OwenKey& key) {
    // The upper 24 of the 32 bits in opposite order.
    return scaledFloat(
        mapped(kByteMaps.reversed, nibblesOf(bytesOf<2, 1, 0, kNone>(owenHash(digits, key)))));
}

HWY_INLINE V scrambledBits(V digits, const OwenKey& key) {
    return reverseBits(owenHash(digits, key));
}

/// scrambledSampleZ, XY and XYZ of a vector of points, into xis[0, kLanes).
HWY_INLINE void storeScrambled(const PointVectors& point, const ScramblingKeys& keys, float* xis) {
    hn::StoreU(scrambledSample(point.z, keys.z), kFloats, xis);
}
HWY_INLINE void storeScrambled(const PointVectors& point, const ScramblingKeys& keys, Float2* xis) {
    hn::StoreInterleaved2(scrambledSample(point.x, keys.x), scrambledSample(point.y, keys.y),
                          kFloats, reinterpret_cast<float*>(xis));
}
HWY_INLINE void storeScrambled(const PointVectors& point, const ScramblingKeys& keys, Float3* xis) {
    hn::StoreInterleaved3(scrambledSample(point.x, keys.x), scrambledSample(point.y, keys.y),
                          scrambledSample(point.z, keys.z), kFloats, reinterpret_cast<float*>(xis));
}

/// scrambledBitsZ, XY and XYZ of them.
HWY_INLINE void storeScrambled(const PointVectors& point, const ScramblingKeys& keys,
                               uint32_t* bits) {
    hn::StoreU(scrambledBits(point.z, keys.z), kWords, bits);
}
HWY_INLINE void storeScrambled(const PointVectors& point, const ScramblingKeys& keys, Bits2* bits) {
    hn::StoreInterleaved2(scrambledBits(point.x, keys.x), scrambledBits(point.y, keys.y), kWords,
                          reinterpret_cast<uint32_t*>(bits));
}
HWY_INLINE void storeScrambled(const PointVectors& point, const ScramblingKeys& keys, Bits3* bits) {
    hn::StoreInterleaved3(scrambledBits(point.x, keys.x), scrambledBits(point.y, keys.y),
                          scrambledBits(point.z, keys.z), kWords,
                          reinterpret_cast<uint32_t*>(bits));
}

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat
HWY_AFTER_NAMESPACE();
#endif

#endif
