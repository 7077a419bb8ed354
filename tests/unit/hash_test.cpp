// SPDX-License-Identifier: Apache-2.0
//
// The integer hashes: that the bijections have inverses, and that the rest is no bijection. How
// random they are is in tests/statistical.

#include "RixRNGInline.h"
#include "wellstrat/bits.h"
#include "wellstrat/hash.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <unordered_set>

namespace {

using namespace wellstrat;

constexpr uint32_t kWords = 1u << 20;

/// The number whose product with odd `a` is 1 modulo 2^32. Newton's iteration doubles the number
/// of right bits, of which a has three to begin with.
uint32_t modularInverse(uint32_t a) {
    uint32_t inverse = a;
    for (int i = 0; i < 4; ++i) inverse *= 2 - a * inverse;
    return inverse;
}

uint32_t undoXorShift(uint32_t x, unsigned shift) {
    uint32_t result = x;
    for (unsigned done = shift; done < 32; done += shift) result = x ^ (result >> shift);
    return result;
}

uint32_t unmix(uint32_t x, uint32_t secondMultiplier) {
    x = undoXorShift(x, 15) * modularInverse(secondMultiplier);
    x = undoXorShift(x, 15) * modularInverse(0x21f0aaadu);
    return undoXorShift(x, 16);
}

uint32_t unmix(uint32_t x) { return unmix(x, 0x735a2d97u); }

uint32_t unpermute(uint32_t x, PermutationKey key) { return unmix(x, key.multiplier) ^ key.mask; }

TEST(Hash, MixBitsHasAnInverse) {
    for (uint32_t i = 0; i < kWords; ++i) {
        const uint32_t word = i * 0x9e3779b1u;
        ASSERT_EQ(unmix(mixBits(word)), word);
    }
}

// Guards against a key that enters in a way that merges words: distinct patterns would then meet.
TEST(Hash, PermuteBitsHasAnInverseForEveryKey) {
    for (uint32_t i = 0; i < kWords; ++i) {
        const uint32_t word = i * 0x9e3779b1u;
        const PermutationKey key = permutationKey(i / 3);
        ASSERT_EQ(unpermute(permuteBits(word, key), key), word);
    }
}

TEST(Hash, MixBitsMapsOnlyZeroToZero) {
    EXPECT_EQ(mixBits(0), 0u);
    EXPECT_NE(permuteBits(0, permutationKey(0)), 0u);
    EXPECT_NE(hashPair(0, 0), 0u);
}

// A sequence of independent words repeats: of 2^20 words, 128 +- 11 equal an earlier one. Outside
// 60 to 196, six sigma, with probability 2e-9. A bijection would have none.
TEST(Hash, HashPairRepeatsAsOftenAsIndependentWords) {
    for (uint32_t a : {0u, 1u, 0xffffffffu}) {
        std::unordered_set<uint32_t> seen;
        for (uint32_t b = 0; b < kWords; ++b) seen.insert(hashPair(a, b));
        const auto repeats = kWords - seen.size();
        EXPECT_GT(repeats, 60u) << "a = " << a;
        EXPECT_LT(repeats, 196u) << "a = " << a;
    }
}

TEST(Hash, HashPairDependsOnTheOrderOfItsArguments) {
    unsigned equal = 0;
    for (uint32_t a = 0; a < 1000; ++a) {
        if (hashPair(a, a + 1) == hashPair(a + 1, a)) ++equal;
    }
    EXPECT_EQ(equal, 0u);
}

TEST(Hash, AllAreConstantExpressions) {
    static_assert(mixBits(1) != mixBits(2), "");
    static_assert(permuteBits(1, permutationKey(2)) != permuteBits(2, permutationKey(2)), "");
    static_assert(HashToUnsigned(1, 2) == hashPair(1, 2), "");
    static_assert(HashToRandom(1, 2) < 1.0f, "");
}

TEST(HashToRandom, IsTheUpper24BitsOfTheHash) {
    for (unsigned b = 0; b < 100000; ++b) {
        const float xi = HashToRandom(7, b);
        ASSERT_EQ(xi, static_cast<float>(HashToUnsigned(7, b) >> 8) / 16777216.0f);
        ASSERT_EQ(xi, HashToRandom(7, b));
    }
}

// Guards against rounding to nearest, which gives 1.0f for the 128 largest words.
TEST(UnitFloat, NoWordGivesOne) {
    for (uint32_t below = 1; below <= 1024; ++below) ASSERT_LT(toUnitFloat(0u - below), 1.0f);
    EXPECT_EQ(toUnitFloat(0xffffffffu), 1.0f - 0x1p-24f);
    EXPECT_EQ(toUnitFloat(0), 0.0f);
}

// Each of the 2^24 values comes from exactly 256 words, so a uniform word gives a uniform float.
TEST(UnitFloat, EveryValueComesFrom256Words) {
    for (uint32_t value = 0; value < (1u << 24); ++value) {
        const float expected = static_cast<float>(value) * 0x1p-24f;
        ASSERT_EQ(toUnitFloat(value << 8), expected);
        ASSERT_EQ(toUnitFloat((value << 8) | 0xffu), expected);
    }
}

} // namespace
