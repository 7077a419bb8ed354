// SPDX-License-Identifier: Apache-2.0
//
// Bit operations and the conversion to float, exhaustively where the inputs can be run through.

#include "wellstrat/bits.h"

#include "wellstrat/hash.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wellstrat {
namespace {

uint32_t naiveReverse(uint32_t x, unsigned width) {
    uint32_t reversed = 0;
    for (unsigned bit = 0; bit < width; ++bit) {
        reversed |= ((x >> bit) & 1u) << (width - 1 - bit);
    }
    return reversed;
}

TEST(Bits, ReverseByteForAllBytesAndAnyHighBits) {
    for (uint32_t x = 0; x < 256; ++x) {
        EXPECT_EQ(reverseByte(x), naiveReverse(x, 8));
        for (uint32_t high = 0; high < 256; ++high) {
            EXPECT_EQ(reverseByte(x | (hashPair(x, high) << 8)), naiveReverse(x, 8));
        }
    }
}

TEST(Bits, ReverseBits) {
    for (unsigned bit = 0; bit < 32; ++bit) EXPECT_EQ(reverseBits(1u << bit), 1u << (31 - bit));
    for (uint32_t i = 0; i < (1u << 16); ++i) {
        const uint32_t x = mixBits(i);
        ASSERT_EQ(reverseBits(x), naiveReverse(x, 32));
        ASSERT_EQ(reverseBits(reverseBits(x)), x);
    }
}

// The upper 23 bits decide: those that go to k begin at the first v with v * n >= k * 2^23.
TEST(Bits, ScaleToRangeSplitsTheWordsEvenly) {
    for (uint32_t n = 1; n <= 512; ++n) {
        EXPECT_EQ(scaleToRange(0, n), 0u);
        EXPECT_EQ(scaleToRange(0xffffffffu, n), n - 1);
        for (uint32_t k = 1; k < n; ++k) {
            const uint32_t first = ((k << 23) + n - 1) / n << 9;
            ASSERT_EQ(scaleToRange(first, n), k);
            ASSERT_EQ(scaleToRange(first - 1, n), k - 1);
        }
    }
}

// All 2^24 results. Guards against rounding up to 1.0f, gaps and uneven steps.
TEST(Bits, UnitFloatsAreAllMultiplesOfTwoToMinus24BelowOne) {
    for (uint32_t k = 0; k < (1u << 24); ++k) {
        const float value = toUnitFloat(k << 8);
        if (value != std::ldexp(static_cast<double>(k), -24)) {
            FAIL() << "toUnitFloat(" << (k << 8) << ") is " << value;
        }
    }
    EXPECT_EQ(toUnitFloat(0xffffffffu), 1.0f - 0x1p-24f);
    EXPECT_LT(toUnitFloat(0xffffffffu), 1.0f);
    EXPECT_EQ(toUnitFloat(0xffu), 0.0f);
    EXPECT_EQ(toUnitFloat(0x100u), 0x1p-24f);
}

} // namespace
} // namespace wellstrat
