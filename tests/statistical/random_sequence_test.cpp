// SPDX-License-Identifier: Apache-2.0
//
// Whether HashToRandom is as good as a sound pseudo-random generator: classical tests on the words
// under it, along b for a fixed a, along a for a fixed b, and on sequences that take turns among
// neighbors. Each test sees the words and the words with their bits in opposite order, so low bits
// must be as good as high ones. False alarms: statistics.h.

#include "RixRNGInline.h"
#include "statistical/marsaglia.h"
#include "statistical/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace statistical;
using wellstrat::reverseBits;

struct Sequence {
    const char* name;
    uint32_t (*at)(uint32_t i);
};

const Sequence kSequences[] = {
    {"AlongBForA0", [](uint32_t i) { return HashToUnsigned(0, i); }},
    {"AlongBForA1", [](uint32_t i) { return HashToUnsigned(1, i); }},
    {"AlongBForALast", [](uint32_t i) { return HashToUnsigned(0xffffffffu, i); }},
    {"AlongBForAnyA", [](uint32_t i) { return HashToUnsigned(0x9e3779b9u, i); }},
    {"AlongBFromTheMiddle", [](uint32_t i) { return HashToUnsigned(3, i + 0x80000000u); }},
    {"AlongBInStepsOf2048", [](uint32_t i) { return HashToUnsigned(5, i * 2048); }},
    {"AlongAForB0", [](uint32_t i) { return HashToUnsigned(i, 0); }},
    {"AlongAForB1", [](uint32_t i) { return HashToUnsigned(i, 1); }},
    {"AlongAInStepsOf65536", [](uint32_t i) { return HashToUnsigned(i * 65536 + i / 65536, 2); }},
    {"Diagonal", [](uint32_t i) { return HashToUnsigned(i, i); }},
    {"TwoNeighborsInTurn", [](uint32_t i) { return HashToUnsigned(6 + i % 2, i / 2); }},
    {"SixteenInTurn", [](uint32_t i) { return HashToUnsigned(i % 16, i / 16); }},
    {"RowsOf4096", [](uint32_t i) { return HashToUnsigned(i / 4096, i % 4096); }},
};

class RandomSequence : public testing::TestWithParam<Sequence> {
protected:
    /// Calls check(words) with a function from index to word, for both bit orders.
    template <typename Check>
    void forBothOrders(Check check) {
        const auto at = GetParam().at;
        {
            SCOPED_TRACE("words");
            check(at);
        }
        SCOPED_TRACE("words reversed");
        check([at](uint32_t i) { return reverseBits(at(i)); });
    }
};

TEST_P(RandomSequence, FrequenciesAreUniform) {
    forBothOrders([](auto word) {
        std::vector<uint32_t> counts(1u << 14);
        for (uint32_t i = 0; i < (1u << 20); ++i) ++counts[word(i) >> 18];
        EXPECT_GE(uniformP(counts), kAlpha);
    });
}

// Knuth, TAOCP vol. 2, section 3.3.2 B, for words 1, 2, 3, 16 and 256 apart, overlapping none.
TEST_P(RandomSequence, PairsAreUniform) {
    forBothOrders([](auto word) {
        for (uint32_t lag : {1u, 2u, 3u, 16u, 256u}) {
            std::vector<uint32_t> counts(1u << 16);
            for (uint32_t i = 0; i < (1u << 20); ++i) {
                const uint32_t first = i / lag * 2 * lag + i % lag;
                ++counts[(word(first) >> 24 << 8) | (word(first + lag) >> 24)];
            }
            EXPECT_GE(uniformP(counts), kAlpha) << "lag " << lag;
        }
    });
}

// Knuth, section 3.3.2 G and exercise 14: with the word that ends a run thrown away, run lengths
// are independent, and a run up has length r with probability 1/r! - 1/(r+1)!.
TEST_P(RandomSequence, RunsUpHaveTheRightLengths) {
    static constexpr unsigned kLongest = 8;
    static constexpr uint32_t kRuns = 1u << 19;
    forBothOrders([](auto word) {
        std::vector<uint32_t> counts(kLongest);
        uint32_t i = 0;
        for (uint32_t run = 0; run < kRuns; ++run) {
            unsigned length = 1;
            for (; word(i + 1) > word(i); ++i) ++length;
            i += 2;
            ++counts[std::min(length, kLongest) - 1];
        }
        std::vector<double> expected(kLongest);
        double inverseFactorial = 1;
        for (unsigned r = 1; r <= kLongest; ++r) {
            inverseFactorial /= r;
            expected[r - 1] = kRuns * inverseFactorial * (r < kLongest ? r / (r + 1.0) : 1.0);
        }
        EXPECT_GE(chiSquareP(counts, expected), kAlpha);
    });
}

TEST_P(RandomSequence, BirthdaySpacingsRepeatAsOftenAsTheyShould) {
    forBothOrders([](auto word) { EXPECT_GE(birthdaySpacingsP(word), kAlpha); });
}

// Guards against bits that are linear functions of others.
TEST_P(RandomSequence, MatricesOf32WordsHaveTheRightRanks) {
    EXPECT_GE(matrixRankP(GetParam().at), kAlpha);
}

// 2^20 independent words have 2^20 * 2^20 / 2 / 2^32 = 128 pairs of equal ones.
TEST_P(RandomSequence, WordsRepeatAsOftenAsTheyShould) {
    std::vector<uint32_t> words(1u << 20);
    for (uint32_t i = 0; i < words.size(); ++i) words[i] = GetParam().at(i);
    std::sort(words.begin(), words.end());
    uint32_t repeats = 0;
    for (std::size_t i = 1; i < words.size(); ++i) repeats += words[i] == words[i - 1];
    EXPECT_GE(normalTail((repeats - 128.0) / std::sqrt(128.0)), kAlpha) << repeats;
}

INSTANTIATE_TEST_SUITE_P(All, RandomSequence, testing::ValuesIn(kSequences),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// The probability of k successes in 32 fair trials.
double binomial32(int k) {
    return std::exp(std::lgamma(33) - std::lgamma(k + 1) - std::lgamma(33 - k)) * 0x1p-32;
}

void expectIndependent(uint32_t a, uint32_t neighbor) {
    constexpr uint32_t kPairs = 1u << 18;
    constexpr unsigned kNearest = 6, kFarthest = 26; // distances beyond are counted with these
    std::vector<uint32_t> cells(1u << 12), distances(kFarthest - kNearest + 1);
    for (uint32_t b = 0; b < kPairs; ++b) {
        const uint32_t first = HashToUnsigned(a, b), second = HashToUnsigned(neighbor, b);
        ++cells[(first >> 26 << 6) | (second >> 26)];
        const auto distance = static_cast<unsigned>(std::bitset<32>(first ^ second).count());
        ++distances[std::clamp(distance, kNearest, kFarthest) - kNearest];
    }
    std::vector<double> expected(distances.size());
    for (unsigned k = 0; k <= 32; ++k) {
        expected[std::clamp(k, kNearest, kFarthest) - kNearest] +=
            kPairs * binomial32(static_cast<int>(k));
    }
    EXPECT_GE(uniformP(cells), kAlpha) << a << ", " << neighbor;
    EXPECT_GE(chiSquareP(distances, expected), kAlpha) << a << ", " << neighbor;
}

// Patterns that differ in one bit, or by one: their sequences share no leading digits, and the
// Hamming distances of their words are binomial.
TEST(RandomSequences, OfNeighborsAreIndependent) {
    for (uint32_t a : {0u, 0x12345678u}) {
        for (unsigned bit = 0; bit < 32; ++bit) expectIndependent(a, a ^ (1u << bit));
        expectIndependent(a, a + 1);
        expectIndependent(a, a - 1);
        expectIndependent(a, ~a);
    }
}

} // namespace
