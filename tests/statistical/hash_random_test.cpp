// SPDX-License-Identifier: Apache-2.0
//
// Whether the 24 bits of a HashToRandom are random: Marsaglia's birthday spacings and matrix ranks
// on its upper and on its lower bits, along the sampleid, along the patternid, and along the
// scramble of a domain. Guards against bits that repeat or that are linear functions of others, and
// against floats whose last digits are poor. dieharder reads the same three streams from
// hash_words.cpp.
//
// False alarms: statistics.h; each test is one check.

#include "RixRNG.h"
#include "statistical/marsaglia.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <tuple>

namespace {

using namespace statistical;

struct Stream {
    const char* name;
    float (*draw)(uint32_t i);
};

template <uint32_t scrambledPattern>
float alongScramble(uint32_t i) {
    const RixRNG::SampleCtx context{scrambledPattern, 0};
    const RixRNG::SampleCtx domain = context.NewDomain(static_cast<RixRNG::Scramble>(i));
    return HashToRandom(domain.patternid, domain.sampleid);
}

const Stream kStreams[] = {
    {"AlongSampleidOfPattern0", [](uint32_t i) { return HashToRandom(0, i); }},
    {"AlongSampleidOfAnyPattern", [](uint32_t i) { return HashToRandom(0xb5297a4du, i); }},
    {"AlongPatternidOfSample0", [](uint32_t i) { return HashToRandom(i, 0); }},
    {"AlongPatternidOfSample196608", [](uint32_t i) { return HashToRandom(i, 196608); }},
    {"AlongScrambleOfPattern0", alongScramble<0>},
    {"AlongScrambleOfAnyPattern", alongScramble<0xb5297a4du>},
};

/// The bits of a draw that a test sees: `count` of them, a divisor of 32, from bit `first` on.
struct Bits {
    const char* name;
    unsigned first, count;
};

const Bits kBits[] = {
    {"Upper16", 8, 16}, {"Lower16", 0, 16}, {"Upper8", 16, 8},
    {"Lower8", 0, 8},   {"Highest", 23, 1}, {"Lowest", 0, 1},
};

class HashRandom : public testing::TestWithParam<std::tuple<Stream, Bits>> {
protected:
    /// 32 bits of as many draws as it takes.
    uint32_t word(uint32_t index) const {
        const auto& [stream, bits] = GetParam();
        const uint32_t draws = 32 / bits.count, mask = (1u << bits.count) - 1;
        uint32_t result = 0;
        for (uint32_t i = index * draws; i < (index + 1) * draws; ++i) {
            const auto value = static_cast<uint32_t>(stream.draw(i) * 0x1p24f);
            result = result << bits.count | (value >> bits.first & mask);
        }
        return result;
    }
};

TEST_P(HashRandom, BirthdaySpacingsRepeatAsOftenAsTheyShould) {
    EXPECT_GE(birthdaySpacingsP([this](uint32_t i) { return word(i); }), kAlpha);
}

TEST_P(HashRandom, MatricesHaveTheRightRanks) {
    EXPECT_GE(matrixRankP([this](uint32_t i) { return word(i); }), kAlpha);
}

INSTANTIATE_TEST_SUITE_P(All, HashRandom,
                         testing::Combine(testing::ValuesIn(kStreams), testing::ValuesIn(kBits)),
                         [](const auto& instance) {
                             return std::string(std::get<0>(instance.param).name) +
                                    std::get<1>(instance.param).name;
                         });

/// The tests themselves: a Weyl sequence has equal spacings, and 32 states of a linear recurrence
/// in a row are never dependent.
TEST(MarsagliasTests, SeeWhatTheyAreFor) {
    EXPECT_LT(birthdaySpacingsP([](uint32_t i) { return i * 0x9e3779b9u; }), kAlpha);
    uint32_t state = 1;
    const auto xorshift = [&state](uint32_t) { // Marsaglia 2003, "Xorshift RNGs"
        state ^= state << 13;
        state ^= state >> 17;
        return state ^= state << 5;
    };
    EXPECT_LT(matrixRankP(xorshift), kAlpha);
}

} // namespace
