// SPDX-License-Identifier: Apache-2.0
//
// Nested uniform scrambling: that it is nested, and that the bits of all nodes are fair and
// independent over seeds. Guards against a scrambling that ignores the prefix, which is a digital
// shift and leaves all tables congruent, and against trees of neighboring seeds that are alike.
//
// False alarms: statistics.h; the scores of one test count as two checks.

#include "statistical/statistics.h"
#include "statistical/tree_bits.h"
#include "wellstrat/owen.h"
#include "wellstrat/tables.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace statistical;
using wellstrat::owenScramble;

TEST(OwenScramble, IsNested) {
    std::mt19937 engine(1);
    for (int trial = 0; trial < 20000; ++trial) {
        const auto seed = static_cast<uint32_t>(engine()), value = static_cast<uint32_t>(engine());
        const uint32_t scrambled = owenScramble(value, seed);
        for (unsigned bit = 0; bit < 32; ++bit) {
            ASSERT_EQ((owenScramble(value ^ (1u << bit), seed) ^ scrambled) >> bit, 1u)
                << "value " << value << ", seed " << seed << ", bit " << bit;
        }
    }
}

TEST(OwenScramble, ChangesTheDigitsAskedForOnly) {
    for (unsigned digits = 0; digits <= 32; ++digits) {
        const uint32_t scrambled = owenScramble(0x12345678u, 9, digits);
        const uint32_t kept = digits == 32 ? 0 : 0xffffffffu >> digits;
        EXPECT_EQ((scrambled ^ 0x12345678u) & kept, 0u);
        EXPECT_EQ((scrambled ^ owenScramble(0x12345678u, 9)) & ~kept, 0u);
    }
}

/// The bits of the nodes of the first eight digits, and of some deeper ones, for the seeds of the
/// tables' kind: hashes of small numbers.
class OwenNodes : public testing::Test {
protected:
    OwenNodes() {
        for (uint32_t prefix = 0; prefix < 128; ++prefix) addPath(prefix << 25);
        for (uint32_t prefix = 1; prefix < 128; ++prefix) addNode(prefix << 20, 12);
        for (uint32_t prefix = 1; prefix < 128; ++prefix) addNode(prefix * 0x02468ac8u, 29);
    }

    BitColumns columns_{1u << 14};

private:
    static uint32_t seed(std::size_t s) {
        const auto i = static_cast<unsigned>(s);
        return wellstrat::tableSeed(i / 3, static_cast<wellstrat::Coordinate>(i % 3));
    }
    void addNode(uint32_t value, unsigned digit) {
        columns_.add(1, [=](std::size_t s) {
            return (owenScramble(value, seed(s)) ^ value) >> (31 - digit);
        });
    }
    /// The nodes on the way to `value` that are on the way to no smaller one.
    void addPath(uint32_t value) {
        for (unsigned digit = 0; digit < 8; ++digit) {
            if ((value & (0xffffffffu >> digit)) == 0) addNode(value, digit);
        }
    }
};

TEST_F(OwenNodes, AreFair) {
    Scores scores;
    for (std::size_t a = 0; a < columns_.size(); ++a) scores.add(columns_.score(a));
    EXPECT_GE(scores.largestP(), kAlpha) << scores.largest();
    EXPECT_GE(scores.meanSquareP(), kAlpha) << scores.meanSquare();
}

TEST_F(OwenNodes, AreIndependentInTwos) {
    Scores scores;
    for (std::size_t a = 0; a < columns_.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) scores.add(columns_.score(a, b));
    }
    EXPECT_GE(scores.largestP(), kAlpha) << scores.largest();
    EXPECT_GE(scores.meanSquareP(), kAlpha) << scores.meanSquare();
}

TEST_F(OwenNodes, AreIndependentInFours) {
    std::mt19937 engine(3);
    const auto any = [&] { return static_cast<std::size_t>(engine() % columns_.size()); };
    Scores scores;
    for (int trial = 0; trial < 100000; ++trial) {
        const std::size_t a = any(), b = any(), c = any(), d = any();
        if (a == b || a == c || a == d || b == c || b == d || c == d) continue;
        scores.add(columns_.score(a, b, c, d));
    }
    EXPECT_GE(scores.largestP(), kAlpha) << scores.largest();
}

} // namespace
