// SPDX-License-Identifier: Apache-2.0
//
// Bit operations on 32-bit words, and the conversion of a word to a float in [0, 1).

#pragma once

#include "wellstrat/platform.h"
#include "wellstrat/vector.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

#if WELLSTRAT_DEVICE_CODE
namespace detail {

// reverseBits and trailingZeros by the instructions that GPUs have for them.
#if defined(__clang__)
__device__ constexpr uint32_t reversedBits(uint32_t x) { return __builtin_bitreverse32(x); }
__device__ constexpr int zerosBelow(uint32_t x) { return __builtin_ctz(x); }
#else
__device__ inline uint32_t reversedBits(uint32_t x) { return __brev(x); }
__device__ inline int zerosBelow(uint32_t x) { return __ffs(static_cast<int>(x)) - 1; }
#endif

} // namespace detail
#endif

/// The bits of `x` in opposite order: bit 0 becomes bit 31. As a fraction of 2^32, the radical
/// inverse of `x` in base 2.
WELLSTRAT_HOST_DEVICE constexpr uint32_t reverseBits(uint32_t x) {
#if WELLSTRAT_DEVICE_CODE
    if (!__builtin_is_constant_evaluated()) return detail::reversedBits(x);
#endif
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    x = ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
    return x;
}

namespace detail {

/// reverseBits of one byte, for all of them: 1 KiB that stays in the cache, where arithmetic would
/// cost a draw 8 % of its time.
struct ReversedBytes {
    uint32_t of[256];

    constexpr ReversedBytes() : of() {
        for (uint32_t i = 0; i < 256; ++i) of[i] = reverseBits(i);
    }
};

inline constexpr ReversedBytes kReversedBytes;

} // namespace detail

/// reverseBits of the low 8 bits of `x`: bits 24 to 31.
WELLSTRAT_HOST_DEVICE constexpr uint32_t reverseLowByte(uint32_t x) {
#if WELLSTRAT_DEVICE_CODE
    return reverseBits(x & 0xffu);
#else
    return detail::kReversedBytes.of[x & 0xffu];
#endif
}

/// The low 8 bits of `x` in opposite order, the others dropped.
WELLSTRAT_HOST_DEVICE constexpr uint32_t reverseByte(uint32_t x) { return reverseLowByte(x) >> 24; }

/// How often 2 divides `x`, which is not 0.
WELLSTRAT_HOST_DEVICE constexpr unsigned trailingZeros(uint32_t x) {
#if WELLSTRAT_DEVICE_CODE
    return static_cast<unsigned>(detail::zerosBelow(x));
#elif defined(__GNUC__)
    return static_cast<unsigned>(__builtin_ctz(x));
#else
    unsigned count = 0;
    for (; (x & 1u) == 0; x >>= 1) ++count;
    return count;
#endif
}

/// Maps a uniform word to [0, n), n <= 512, by its upper 23 bits and without a division or a 64-bit
/// product: floor(x / 2^9 * n / 2^23). No result is likelier than another by more than n / 2^23.
WELLSTRAT_HOST_DEVICE constexpr uint32_t scaleToRange(uint32_t x, uint32_t n) {
    return ((x >> 9) * n) >> 23;
}

/// The float v / 2^32, rounded down to a multiple of 2^-24: uniform for uniform `v`, in [0, 1).
///
/// Of the four usual ways this is the one without a flaw:
///
///     v * 2^-32 in float       rounds to nearest: 1.0f for the 128 largest v
///     the same, then min()     never 1.0f, but the last value is far too likely
///     mantissa trick, [1,2)-1  only 23 bits
///     (v >> 8) * 2^-24         24 bits, all exact, every value from 256 words   <- this
WELLSTRAT_HOST_DEVICE constexpr float toUnitFloat(uint32_t v) {
    return static_cast<float>(v >> 8) * 0x1p-24f;
}

namespace detail {

#if WELLSTRAT_VECTOR_TYPES

/// Vector registers convert two words with half of the instructions, and do not wait for the
/// integer units.
using Words __attribute__((vector_size(16))) = uint32_t;
using WordPairs __attribute__((vector_size(16))) = uint64_t;
using Integers __attribute__((vector_size(16))) = int32_t;
using Floats __attribute__((vector_size(16))) = float;

inline Floats toUnitFloats(Words v) {
    return __builtin_convertvector(reinterpret_cast<Integers>(v >> 8), Floats) * 0x1p-24f;
}

/// toUnitFloat of the first word, where it is in such a register already.
inline float toUnitFloat(Words v) { return toUnitFloats(v)[0]; }

#if WELLSTRAT_VECTOR_PRODUCTS

/// The 64-bit products of the lower words of both halves.
inline WordPairs products(WordPairs a, WordPairs b) {
    return reinterpret_cast<WordPairs>(
        __builtin_ia32_pmuludq128(reinterpret_cast<Integers>(a), reinterpret_cast<Integers>(b)));
}

/// The words with their lower and upper 16 bits exchanged.
inline Words exchangedHalves(Words v) {
    using Halves __attribute__((vector_size(16))) = uint16_t;
    const auto halves = reinterpret_cast<Halves>(v);
    return reinterpret_cast<Words>(__builtin_shufflevector(halves, halves, 1, 0, 3, 2, 5, 4, 7, 6));
}

#endif

/// The 64-bit product of two words, in a vector register from the start.
inline WordPairs product(uint32_t a, uint32_t b) {
#if WELLSTRAT_VECTOR_PRODUCTS
    return products(reinterpret_cast<WordPairs>(Words{a}), reinterpret_cast<WordPairs>(Words{b}));
#else
    return WordPairs{uint64_t{a} * b};
#endif
}

#else

using Words = uint32_t;
using stream1::toUnitFloat;

#endif

} // namespace detail

/// toUnitFloat of both halves of (a * b) ^ shift, a product of 64 bits, the lower half first.
WELLSTRAT_HOST_DEVICE inline Float2 toUnitFloats(uint32_t a, uint32_t b, uint64_t shift) {
#if WELLSTRAT_VECTOR_TYPES
    const auto shifted = detail::product(a, b) ^ detail::WordPairs{shift};
    const detail::Floats floats = detail::toUnitFloats(reinterpret_cast<detail::Words>(shifted));
    Float2 result;
    __builtin_memcpy(&result, &floats, sizeof result);
    return result;
#else
    const uint64_t word = (uint64_t{a} * b) ^ shift;
    return {toUnitFloat(static_cast<uint32_t>(word)),
            toUnitFloat(static_cast<uint32_t>(word >> 32))};
#endif
}

} // namespace stream1
} // namespace wellstrat
