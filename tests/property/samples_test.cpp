// SPDX-License-Identifier: Apache-2.0
//
// The promises hold for what users draw: through RixRNG, for many patterns, at aligned blocks of
// every size, up to the end of the tables and beyond.

#include "RixRNG.h"

#include "property/stratified.h"
#include "statistical/statistics.h"

#include <gtest/gtest.h>

#include <vector>

namespace wellstrat::test {
namespace {

#ifdef NDEBUG
constexpr unsigned kPatterns = 100;
#else
constexpr unsigned kPatterns = 8;
#endif

constexpr unsigned kBlocks = kStratifiedSamples / kTableSize;

uint32_t patternNumber(unsigned i) { return i < 2 ? 0u - i : hashPair(0x7061u, i); }

std::string blockName(uint32_t pattern, unsigned block) {
    return "pattern " + std::to_string(pattern) + ", block " + std::to_string(block);
}

std::vector<RtFloat3> generateBlock(uint32_t pattern, unsigned block) {
    RixRNG::SampleCtx context{pattern, block * kTableSize};
    RixRNG rng(&context, 1);
    std::vector<RtFloat3> xis;
    for (unsigned i = 0; i < kTableSize; ++i) xis.push_back(rng.GenerateSample3D(0));
    return xis;
}

TEST(Samples, GeneratedBlocksAreStratified) {
    for (unsigned i = 0; i < kPatterns; ++i) {
        const uint32_t pattern = patternNumber(i);
        const unsigned middle = 1 + i % (kBlocks - 2);
        for (const unsigned block : {0u, middle, kBlocks - 1}) {
            expectStratified(generateBlock(pattern, block), blockName(pattern, block));
        }
    }
}

TEST(Samples, EveryBlockOfAPatternIsStratified) {
    const uint32_t pattern = 0xc0ffee;
    for (unsigned block = 0; block < kBlocks; ++block) {
        expectStratified(generateBlock(pattern, block), blockName(pattern, block));
    }
}

// As published Bxdfs draw: a 2D sample for the direction and a 1D sample for the lobe, from one
// context. Guards against a 1D sample that repeats a coordinate of the 2D sample.
TEST(Samples, DirectionAndLobeAreOneStratifiedPoint) {
    for (unsigned i = 0; i < kPatterns; ++i) {
        std::vector<RixRNG::SampleCtx> contexts;
        for (unsigned s = 0; s < kTableSize; ++s) contexts.push_back({patternNumber(i), s});
        const RixRNG rng(contexts.data(), kTableSize);
        std::vector<RtFloat2> direction(kTableSize);
        std::vector<float> lobe(kTableSize);
        rng.DrawSamples2D(direction.data());
        rng.DrawSamples1D(lobe.data());
        std::vector<RtFloat3> xis;
        for (unsigned s = 0; s < kTableSize; ++s) {
            xis.emplace_back(direction[s].x, direction[s].y, lobe[s]);
        }
        expectStratified(xis, blockName(patternNumber(i), 0));
    }
}

TEST(Samples, OrderAndRepetitionOfDrawsChangeNothing) {
    const uint32_t pattern = 0xabcdef;
    std::vector<RtFloat3> forward;
    for (uint32_t s = 0; s < 2 * kTableSize; ++s) forward.push_back(sample3D(pattern, s));
    for (uint32_t s = 2 * kTableSize; s-- > 0;) {
        sample3D(hashPair(s, 0), hashPair(s, 1));
        ASSERT_EQ(sample3D(pattern, s), forward[s]);
        ASSERT_EQ(sample3D(pattern, s), forward[s]);
        ASSERT_EQ(sample2D(pattern, s), RtFloat2(forward[s].x, forward[s].y));
        ASSERT_EQ(sample1D(pattern, s), forward[s].z);
    }
}

// From sample 196608 on: hashes, in the order of coordinates that lookup.h states, up to 2^32 - 1.
TEST(Samples, RunOutIsHashToRandom) {
    EXPECT_EQ(kStratifiedSamples, 196608u);
    for (unsigned i = 0; i < 100; ++i) {
        const uint32_t pattern = patternNumber(i);
        for (const uint32_t first : {kStratifiedSamples, 0x7ffffff0u, 0xffffffe0u}) {
            for (uint32_t s = first; s < first + 31; ++s) {
                const RtFloat3 xi = sample3D(pattern, s);
                ASSERT_EQ(xi.z, HashToRandom(pattern, s));
                ASSERT_EQ(xi.x, toUnitFloat(randomBits(pattern, s, Coordinate::x)));
                ASSERT_EQ(xi.y, toUnitFloat(randomBits(pattern, s, Coordinate::y)));
                ASSERT_EQ(sample1D(pattern, s), xi.z);
                ASSERT_EQ(sample2D(pattern, s), RtFloat2(xi.x, xi.y));
            }
        }
        // The last sample from the tables is none of these.
        EXPECT_NE(sample1D(pattern, kStratifiedSamples - 1),
                  HashToRandom(pattern, kStratifiedSamples - 1));
    }
    EXPECT_EQ(sample1D(3, 0xffffffffu), HashToRandom(3, 0xffffffffu));
}

// Guards against one hash for two coordinates: 16 x 16 cells of each pair of coordinates of 2^18
// samples beyond the tables are equally full.
TEST(Samples, RunOutCoordinatesAreIndependent) {
    std::vector<uint32_t> counts[3];
    for (auto& cells : counts) cells.resize(256);
    const auto cell = [](float a, float b) {
        return static_cast<unsigned>(a * 16) * 16 + static_cast<unsigned>(b * 16);
    };
    for (uint32_t i = 0; i < (1u << 18); ++i) {
        const RtFloat3 xi = sample3D(i / 512, kStratifiedSamples + i % 512);
        ++counts[0][cell(xi.x, xi.y)];
        ++counts[1][cell(xi.y, xi.z)];
        ++counts[2][cell(xi.z, xi.x)];
    }
    for (const auto& cells : counts) EXPECT_GT(statistical::uniformP(cells), statistical::kAlpha);
}

} // namespace
} // namespace wellstrat::test
