// SPDX-License-Identifier: Apache-2.0
//
// Samples over patterns: at any fixed sampleid each coordinate is uniform, and the coordinates, the
// table, and the samples of related patterns are independent. This is what makes estimates
// unbiased and pixels independent of each other. Patterns are what users have: counted up, hashed,
// and those of cameras. False alarms: statistics.h.

#include "RixRNGInline.h"
#include "statistical/statistics.h"
#include "wellstrat/camera.h"
#include "wellstrat/lookup.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace statistical;
using namespace wellstrat;

constexpr uint32_t kPatterns = 1u << 20;
constexpr unsigned kWidth = 1024; // of the image of the camera patterns
constexpr Scramble kSomeDomain = static_cast<Scramble>(0x2d96c92bu);

struct Family {
    const char* name;
    unsigned (*pattern)(uint32_t i);
};

unsigned cameraPattern(uint32_t i, unsigned frame) {
    return cameraContext(static_cast<int>(i % kWidth), static_cast<int>(i / kWidth), frame, 0)
        .patternid;
}

const Family kFamilies[] = {
    {"Sequential", [](uint32_t i) { return i; }},
    {"SequentialInUpperBits", [](uint32_t i) { return i << 12; }},
    {"Hashed", [](uint32_t i) { return HashToUnsigned(1, i); }},
    {"Camera", [](uint32_t i) { return cameraPattern(i, 0); }},
    {"CameraLens", [](uint32_t i) { return derivePattern(cameraPattern(i, 7), kLensScramble); }},
    {"DomainsOfOnePattern", [](uint32_t i) { return derivePattern(5, static_cast<Scramble>(i)); }},
    {"DistributionsOfOnePattern",
     [](uint32_t i) {
         return SampleCtx{5, i}.NewDomainDistrib(kSomeDomain, 0).patternid;
     }},
};

/// The 24 bits of a sample.
uint32_t bitsOf(float xi) { return static_cast<uint32_t>(xi * 0x1p24f); }

class Uniformity : public testing::TestWithParam<Family> {
protected:
    /// Chi-square over 2^bits cells of cell(i), for all patterns.
    template <typename Cell>
    static double pValue(unsigned bits, Cell cell) {
        std::vector<uint32_t> counts(std::size_t{1} << bits);
        for (uint32_t i = 0; i < kPatterns; ++i) ++counts[cell(i)];
        return uniformP(counts);
    }
    static unsigned pattern(uint32_t i) { return GetParam().pattern(i); }
};

struct CellCounts {
    std::vector<uint32_t> high{std::vector<uint32_t>(1u << 10)};
    std::vector<uint32_t> low{std::vector<uint32_t>(1u << 10)};
    void add(float xi) {
        ++high[bitsOf(xi) >> 14];
        ++low[bitsOf(xi) & 1023u];
    }
};

// Guards against coordinates that share a hash: each is uniform, the pairs are not.
TEST_P(Uniformity, OfEachCoordinateAndOfAllThreeTogether) {
    for (const unsigned sampleid :
         {0u, 1u, 255u, 256u, 4095u, 4096u, 100000u, 196607u, 196608u, 0xffffffffu}) {
        CellCounts x, y, z;
        std::vector<uint32_t> xy(1u << 14), xyz(1u << 15), lowXyz(1u << 15);
        for (uint32_t i = 0; i < kPatterns; ++i) {
            const Float3 xi = sample3D(pattern(i), sampleid);
            x.add(xi.x);
            y.add(xi.y);
            z.add(xi.z);
            const uint32_t bx = bitsOf(xi.x), by = bitsOf(xi.y), bz = bitsOf(xi.z);
            ++xy[(bx >> 17 << 7) | (by >> 17)];
            ++xyz[(bx >> 19 << 10) | (by >> 19 << 5) | (bz >> 19)];
            ++lowXyz[((bx & 31u) << 10) | ((by & 31u) << 5) | (bz & 31u)];
        }
        SCOPED_TRACE("sampleid " + std::to_string(sampleid));
        EXPECT_GE(uniformP(x.high), kAlpha);
        EXPECT_GE(uniformP(x.low), kAlpha);
        EXPECT_GE(uniformP(y.high), kAlpha);
        EXPECT_GE(uniformP(y.low), kAlpha);
        EXPECT_GE(uniformP(z.high), kAlpha);
        EXPECT_GE(uniformP(z.low), kAlpha);
        EXPECT_GE(uniformP(xy), kAlpha);
        EXPECT_GE(uniformP(xyz), kAlpha);
        EXPECT_GE(uniformP(lowXyz), kAlpha);
    }
}

// A table that is chosen more often than others shows its own error in the mean of all pixels.
TEST_P(Uniformity, OfTheTableChosen) {
    for (const unsigned block : {0u, 1u, 23u, 47u}) {
        std::vector<uint32_t> counts(kTableCount);
        for (uint32_t i = 0; i < kPatterns; ++i) {
            ++counts[tableOfBlock(patternSeed(pattern(i)), block)];
        }
        EXPECT_GE(uniformP(counts), kAlpha) << "block " << block;
    }
}

TEST_P(Uniformity, OfTheTableAndEachShiftTogether) {
    for (const Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
        std::vector<uint32_t> counts(kTableCount * 64);
        for (uint32_t i = 0; i < kPatterns; ++i) {
            const uint32_t seed = patternSeed(pattern(i));
            ++counts[tableOfBlock(seed, 0) * 64 + (digitalShift(seed, c) >> 26)];
        }
        EXPECT_GE(uniformP(counts), kAlpha) << "coordinate " << static_cast<unsigned>(c);
    }
}

// Pixels side by side, above each other, 256 apart, in the next frame, and two domains of one.
TEST_P(Uniformity, OfTwoRelatedPatternsTogether) {
    const auto pairP = [](auto other) {
        return pValue(14, [&](uint32_t i) {
            const float a = sample1D(pattern(i), 9), b = sample1D(other(i), 9);
            return (bitsOf(a) >> 17 << 7) | (bitsOf(b) >> 17);
        });
    };
    for (const uint32_t distance : {1u, 2u, 256u, kWidth, 65536u}) {
        EXPECT_GE(pairP([=](uint32_t i) { return pattern(i + distance); }), kAlpha) << distance;
    }
    EXPECT_GE(pairP([](uint32_t i) { return derivePattern(pattern(i), kSomeDomain); }), kAlpha);
    EXPECT_GE(pairP([](uint32_t i) { return derivePattern(pattern(i), Scramble{}); }), kAlpha);
    EXPECT_GE(pairP([](uint32_t i) { return pattern(i) + 1; }), kAlpha);
    EXPECT_GE(pairP([](uint32_t i) { return pattern(i) ^ 0x80000000u; }), kAlpha);
}

INSTANTIATE_TEST_SUITE_P(Over, Uniformity, testing::ValuesIn(kFamilies),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Uniformities, OfAPixelOverFrames) {
    std::vector<uint32_t> pairs(1u << 14);
    for (uint32_t i = 0; i < kPatterns; ++i) {
        const unsigned frame = i / 512;
        const float a = sample1D(cameraPattern(i % 512, frame), 0);
        const float b = sample1D(cameraPattern(i % 512, frame + 1), 0);
        ++pairs[(bitsOf(a) >> 17 << 7) | (bitsOf(b) >> 17)];
    }
    EXPECT_GE(uniformP(pairs), kAlpha);
}

// The digits after the 12th of the points of the tables: over all points, in pairs of points that
// follow each other, and of points that have the same place in two tables. Over all points they
// may be more even than chance has them.
TEST(Uniformities, OfDigits13To24OfTheTables) {
    const auto digits = [](unsigned table, unsigned index, Coordinate c) {
        return (tableValue(table, index, c) >> 8) & 0xfffu;
    };
    std::vector<uint32_t> x(1u << 12), y(1u << 12), z(1u << 12), xyz(1u << 12);
    std::vector<uint32_t> inSequence(1u << 12), inTwoTables(1u << 12), strataAndDigits(1u << 12);
    for (unsigned table = 0; table < kTableCount; ++table) {
        for (unsigned i = 0; i < kTableSize; ++i) {
            const uint32_t dx = digits(table, i, Coordinate::x);
            const uint32_t dy = digits(table, i, Coordinate::y);
            const uint32_t dz = digits(table, i, Coordinate::z);
            ++x[dx];
            ++y[dy];
            ++z[dz];
            ++xyz[(dx >> 8 << 8) | (dy >> 8 << 4) | (dz >> 8)];
            if (i % 2 == 0)
                ++inSequence[(dx >> 6 << 6) | (digits(table, i + 1, Coordinate::x) >> 6)];
            ++inTwoTables[(dx >> 6 << 6) |
                          (digits((table + 1) % kTableCount, i, Coordinate::x) >> 6)];
            ++strataAndDigits[(tableValue(table, i, Coordinate::x) >> 26 << 6) | (dx >> 6)];
        }
    }
    EXPECT_GE(uniformTail(x), kAlpha);
    EXPECT_GE(uniformTail(y), kAlpha);
    EXPECT_GE(uniformTail(z), kAlpha);
    EXPECT_GE(uniformP(xyz), kAlpha);
    EXPECT_GE(uniformP(inSequence), kAlpha);
    EXPECT_GE(uniformP(inTwoTables), kAlpha);
    EXPECT_GE(uniformP(strataAndDigits), kAlpha);
}

} // namespace
