// SPDX-License-Identifier: Apache-2.0
//
// Deriving a domain is two operations, so that the hash of the draw has to do the mixing. Whatever
// patterns the parents have and along whatever path of scrambles, the samples of a domain must be
// uniform over the parents, and those of two domains independent: values, tables and orders. And
// two domains must share no more patterns than sets of random words do. Guards against derivations
// that the hash of the draw does not undo. None of the families here was used to choose a constant.
//
// False alarms: statistics.h; 7 families x 8 pairs of paths x 8 checks.

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

constexpr uint32_t kParents = 1u << 18;

struct Family {
    const char* name;
    uint32_t (*pattern)(uint32_t i);
};

uint32_t cameraPattern(uint32_t i) {
    return cameraContext(static_cast<int>(i % 640), static_cast<int>(i / 640), 31, 0).patternid;
}

const Family kFamilies[] = {
    {"CountingUp", [](uint32_t i) { return i; }},
    {"CountingDown", [](uint32_t i) { return 0x80000000u - i; }},
    {"MultiplesOf12", [](uint32_t i) { return 12 * i; }},
    {"MultiplesOf16384", [](uint32_t i) { return i << 14; }},
    {"BitReversed", [](uint32_t i) { return reverseBits(i); }},
    {"RowsAndColumns", [](uint32_t i) { return i % 512 | i / 512 << 16; }},
    {"Camera", cameraPattern},
};

/// Scrambles from the camera down.
using Path = std::vector<uint32_t>;

uint32_t derive(uint32_t pattern, const Path& path) {
    for (const uint32_t scramble : path) {
        pattern = derivePattern(pattern, static_cast<Scramble>(scramble));
    }
    return pattern;
}

/// Scrambles that count up, that differ in one bit, that come twice and in another order.
const Path kPaths[][2] = {{{0}, {1}},
                          {{0}, {0x80000000u}},
                          {{0x2d96c92bu}, {0x3917fe2eu}},
                          {{}, {0}},
                          {{1, 2}, {2, 1}},
                          {{5}, {5, 5}},
                          {{1, 1, 1}, {1, 1, 2}},
                          {{7, 8, 9, 10}, {10, 9, 8, 7}}};

std::string nameOf(const Path& path) {
    std::string name = "parent";
    for (const uint32_t scramble : path) name += " > " + std::to_string(scramble);
    return name;
}

class DerivedDomains : public testing::TestWithParam<Family> {
protected:
    /// Calls check(first, second), which makes a cell in [0, 2^bits) of the seeds of two domains,
    /// for all parents, and judges how full the cells are.
    template <typename Cell>
    static double pValue(const Path (&paths)[2], std::size_t cells, Cell cell) {
        std::vector<uint32_t> counts(cells);
        for (uint32_t i = 0; i < kParents; ++i) {
            const uint32_t parent = GetParam().pattern(i);
            ++counts[cell(derive(parent, paths[0]), derive(parent, paths[1]))];
        }
        return uniformP(counts);
    }
};

uint32_t upperBits(float xi, unsigned bits) {
    return static_cast<uint32_t>(xi * static_cast<float>(1u << bits));
}

TEST_P(DerivedDomains, ChooseTablesUniformlyAndIndependently) {
    for (const auto& paths : kPaths) {
        SCOPED_TRACE(nameOf(paths[0]) + " and " + nameOf(paths[1]));
        const auto table = [](uint32_t pattern) { return tableOfBlock(patternSeed(pattern), 0); };
        EXPECT_GE(pValue(paths, kTableCount, [&](uint32_t, uint32_t b) { return table(b); }),
                  kAlpha);
        EXPECT_GE(pValue(paths, 64 * 64,
                         [&](uint32_t a, uint32_t b) { return table(a) / 6 * 64 + table(b) / 6; }),
                  kAlpha);
    }
}

// Where two domains look up the same sample, and how the order of one lies to that of the other:
// the bits in which their places of two samples differ are alike if they are in lockstep.
TEST_P(DerivedDomains, ShuffleIndependently) {
    for (const auto& paths : kPaths) {
        SCOPED_TRACE(nameOf(paths[0]) + " and " + nameOf(paths[1]));
        const auto place = [](uint32_t pattern, uint32_t sampleid) {
            return shuffledPlace(patternSeed(pattern), sampleid);
        };
        EXPECT_GE(pValue(paths, 1u << 14,
                         [&](uint32_t a, uint32_t b) {
                             return place(a, 77) >> 1 << 7 | place(b, 77) >> 1;
                         }),
                  kAlpha);
        EXPECT_GE(pValue(paths, 1u << 14,
                         [&](uint32_t a, uint32_t b) {
                             return (place(a, 3) ^ place(b, 3)) >> 1 << 7 |
                                    (place(a, 300) ^ place(b, 300)) >> 1;
                         }),
                  kAlpha);
    }
}

TEST_P(DerivedDomains, HaveUniformAndIndependentSamples) {
    for (const auto& paths : kPaths) {
        SCOPED_TRACE(nameOf(paths[0]) + " and " + nameOf(paths[1]));
        for (const uint32_t sampleid : {0u, 1000u}) {
            EXPECT_GE(pValue(paths, 1u << 15,
                             [&](uint32_t, uint32_t b) {
                                 const Float3 xi = sample3D(b, sampleid);
                                 return upperBits(xi.x, 5) << 10 | upperBits(xi.y, 5) << 5 |
                                        upperBits(xi.z, 5);
                             }),
                      kAlpha);
            EXPECT_GE(pValue(paths, 1u << 14,
                             [&](uint32_t a, uint32_t b) {
                                 return upperBits(sample1D(a, sampleid), 7) << 7 |
                                        upperBits(sample2D(b, sampleid).x, 7);
                             }),
                      kAlpha);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, DerivedDomains, testing::ValuesIn(kFamilies),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// The parent along `path` that has this pattern.
uint32_t parentOf(uint32_t pattern, const Path& path) {
    for (auto scramble = path.rbegin(); scramble != path.rend(); ++scramble) {
        pattern = parentPattern(pattern, static_cast<Scramble>(*scramble));
    }
    return pattern;
}

/// Whether two of the patterns of 2^21 parents that count up are also patterns of others of these
/// parents along another path. Of random sets it is true with a probability of 2^-22, of sets that
/// have most of their patterns in common it is true.
bool shareMany(const Path& one, const Path& other) {
    const auto isShared = [&](uint32_t parent) {
        return parentOf(derive(parent, one), other) < (1u << 21);
    };
    return isShared(77) && isShared(1234567);
}

// Two domains share the patterns of 2^21 pixels no more often than random sets do: 0.95 pairs in
// all are expected, and more than 12 have a probability of 1e-10. Guards against one multiplier for
// all scrambles, and against scrambles that may change places: each makes a thousand or more such
// pairs.
TEST(DerivedPatterns, AreSharedNoMoreThanRandomSets) {
    constexpr uint32_t kDomains = 1415;
    EXPECT_EQ(parentOf(derive(12345, {1, 2, 3}), {1, 2, 3}), 12345u);
    unsigned siblings = 0, cousins = 0;
    for (uint32_t a = 0; a < kDomains; ++a) {
        for (uint32_t b = 0; b < kDomains; ++b) {
            if (a == b) continue;
            siblings += shareMany({a}, {b});
            cousins += shareMany({a, b}, {b, a});
        }
    }
    EXPECT_LE(siblings, 12u);
    EXPECT_LE(cousins, 12u);
}

} // namespace
