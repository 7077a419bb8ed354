// SPDX-License-Identifier: Apache-2.0
//
// Nested uniform scrambling permutes elementary intervals, and takes each value to any other (Owen
// 1995, section 3). That its swaps are fair and independent is for tests/statistical.

#include "wellstrat/owen.h"

#include "statistical/statistics.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace wellstrat {
namespace {

unsigned firstDifference(uint32_t a, uint32_t b) {
    unsigned digit = 0;
    while (digit < 32 && ((a ^ b) >> (31 - digit)) == 0) ++digit;
    return digit;
}

// Two values part at the same digit before and after, so elementary intervals stay such.
TEST(Owen, ScramblingIsNested) {
    for (uint32_t i = 0; i < (1u << 14); ++i) {
        const uint32_t seed = mixBits(i);
        const uint32_t a = hashPair(seed, 0);
        const uint32_t b = a ^ (hashPair(seed, 1) >> (i % 32));
        ASSERT_EQ(firstDifference(owenScramble(a, seed), owenScramble(b, seed)),
                  firstDifference(a, b));
    }
}

TEST(Owen, PrefixesArePermutedAndDecideAlone) {
    for (unsigned digits = 1; digits <= 12; ++digits) {
        std::set<uint32_t> images;
        for (uint32_t prefix = 0; prefix < (1u << digits); ++prefix) {
            const uint32_t value = prefix << (32 - digits);
            const uint32_t rest = hashPair(prefix, digits) >> digits;
            const uint32_t scrambled = owenScramble(value, 5, digits);
            images.insert(scrambled);
            // More digits in the value or in the scrambling leave the first ones as they are.
            EXPECT_EQ(owenScramble(value | rest, 5, digits), scrambled | rest);
            EXPECT_EQ(owenScramble(value | rest, 5) >> (32 - digits), scrambled >> (32 - digits));
        }
        EXPECT_EQ(images.size(), std::size_t{1} << digits);
    }
    EXPECT_EQ(owenScramble(0x12345678u, 5, 0), 0x12345678u);
}

// False alarms: statistics.h.
TEST(Owen, ValuesAreUniformOverSeeds) {
    for (const uint32_t value : {0u, 0xffffffffu, 0x80000000u, 0x12345678u}) {
        for (const unsigned shift : {24u, 16u, 8u, 0u}) {
            std::vector<uint32_t> counts(256);
            for (uint32_t seed = 0; seed < 65536; ++seed) {
                ++counts[(owenScramble(value, seed) >> shift) & 0xffu];
            }
            EXPECT_GT(statistical::uniformP(counts), statistical::kAlpha)
                << "value " << value << ", shift " << shift;
        }
    }
}

} // namespace
} // namespace wellstrat
