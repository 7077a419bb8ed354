// SPDX-License-Identifier: Apache-2.0
//
// BlueProgressive and its contexts: where they begin, how they are derived, what is drawn of them.
// That the samples are stratified is for tests/property/blue_test.cpp.

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/camera.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <vector>

namespace wellstrat::test {
namespace {

constexpr auto kScramble = static_cast<Scramble>(0x2d96c92bu);
constexpr uint32_t kPlace = kRanks - 1;

void expectEqual(SampleCtx a, SampleCtx b) {
    EXPECT_EQ(a.patternid, b.patternid);
    EXPECT_EQ(a.sampleid, b.sampleid);
}

uint32_t stateOf(unsigned patternid) { return patternid >> 12; }

/// Whether a function of [0, n) takes n values, all below 2^20.
template <typename Function>
bool isInjective(uint32_t n, Function function) {
    std::vector<bool> seen(1u << 20);
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t value = function(i);
        if (value >> 20 != 0 || seen[value]) return false;
        seen[value] = true;
    }
    return true;
}

// ---- where contexts begin

TEST(BlueContext, AllTilesOfASeedHaveStatesOfTheirOwn) {
    for (const unsigned seed : {0u, 1u, 0xffffffffu}) {
        EXPECT_TRUE(isInjective(1u << 20, [&](uint32_t tile) {
            const int x = 64 * static_cast<int>(tile % 1024),
                      y = 64 * static_cast<int>(tile / 1024);
            return stateOf(blueContext(x, y, seed, 0).patternid);
        }));
    }
}

TEST(BlueContext, ATileHasOneStateAndAllPlaces) {
    for (const auto& [left, top] : {std::pair(0, 0), std::pair(-64, 128), std::pair(-65536, -64)}) {
        const uint32_t state = stateOf(blueContext(left, top, 3, 0).patternid);
        std::vector<bool> seen(kRanks);
        for (int p = 0; p < static_cast<int>(kRanks); ++p) {
            const SampleCtx sc = blueContext(left + p % 64, top + p / 64, 3, 0);
            EXPECT_EQ(stateOf(sc.patternid), state);
            EXPECT_FALSE(seen[sc.patternid & kPlace]);
            seen[sc.patternid & kPlace] = true;
        }
    }
}

/// How far two places are from each other on the torus: 1 for neighbors.
int distance(uint32_t a, uint32_t b) {
    const auto apart = [](uint32_t u, uint32_t v) {
        const int d = static_cast<int>((u - v) & 63u);
        return std::min(d, 64 - d);
    };
    return apart(a & 63u, b & 63u) + apart(a >> 6, b >> 6);
}

// Tiles are shifted, flipped and transposed, and so in the domains again. All ways to flip and
// transpose occur.
TEST(BlueContext, NeighborsStayNeighbors) {
    unsigned ways = 0;
    for (int tile = -50; tile < 50; ++tile) {
        const auto place = [&](int x, int y) {
            return blueContext(64 * tile + x, 64 * 7 + y, 0, 0).patternid & kPlace;
        };
        for (int i = 0; i < 63; ++i) {
            EXPECT_EQ(distance(place(i, 9), place(i + 1, 9)), 1);
            EXPECT_EQ(distance(place(9, i), place(9, i + 1)), 1);
        }
        const uint32_t right = (place(1, 0) - place(0, 0)) & 63u;
        const uint32_t down = (place(0, 1) - place(0, 0)) & 63u;
        const bool isTransposed = right == 0;
        const uint32_t across = isTransposed ? down : right;
        const uint32_t along =
            (place(isTransposed ? 1 : 0, isTransposed ? 0 : 1) >> 6) - (place(0, 0) >> 6);
        ways |= 1u << (4 * isTransposed + 2 * (across == 1) + ((along & 63u) == 1));
    }
    EXPECT_EQ(ways, 0xffu);
}

TEST(BlueContext, CoordinatesCountModulo65536) {
    for (const int x : {0, 1, -1, 64, 32767, -32768, 65535}) {
        for (const int y : {0, -200, 40000}) {
            const SampleCtx sc = blueContext(x, y, 5, 9);
            expectEqual(sc, blueContext(x + 65536, y, 5, 9));
            expectEqual(sc, blueContext(x, y - 65536, 5, 9));
            EXPECT_EQ(sc.sampleid, 9u);
        }
    }
    const int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    expectEqual(blueContext(least, most, 1, 2), blueContext(0, -1, 1, 2));
}

TEST(BlueContext, SeedsAreDifferentPictures) {
    unsigned same = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const unsigned pattern = blueContext(70, 700, seed, 0).patternid;
        same += stateOf(pattern) == stateOf(blueContext(70, 700, seed + 1, 0).patternid);
    }
    EXPECT_LE(same, 3u); // 0.001 are expected
}

// ---- how contexts are derived

TEST(BlueDomain, DerivingIsABijectionThatKeepsThePlace) {
    for (const uint32_t place : {0u, 1234u, kPlace}) {
        EXPECT_TRUE(isInjective(1u << 20, [&](uint32_t state) {
            const unsigned child = deriveBluePattern(state << 12 | place, kScramble);
            EXPECT_EQ(child & kPlace, place);
            EXPECT_EQ(parentBluePattern(child, kScramble), state << 12 | place);
            return stateOf(child);
        }));
    }
}

TEST(BlueDomain, VisitsOfADistributionHaveStatesOfTheirOwn) {
    EXPECT_TRUE(isInjective(1u << 20, [](uint32_t sampleid) {
        const SampleCtx child = newBlueDomainDistrib({0xabcde123u, sampleid}, kScramble, 7);
        EXPECT_EQ(child.patternid & kPlace, 0x123u);
        EXPECT_EQ(child.sampleid, 7u);
        return stateOf(child.patternid);
    }));
    // Beyond these, too, they differ from the neighbors'.
    for (const uint32_t sampleid : {1u << 20, 0x80000000u, 0xfffffffeu}) {
        EXPECT_NE(newBlueDomainDistrib({5, sampleid}, kScramble, 0).patternid,
                  newBlueDomainDistrib({5, sampleid + 1}, kScramble, 0).patternid);
        EXPECT_NE(newBlueDomainDistrib({5, sampleid}, kScramble, 0).patternid,
                  newBlueDomainDistrib({5, sampleid & 0xfffffu}, kScramble, 0).patternid);
    }
}

class BlueTest : public testing::Test {
protected:
    BlueTest() {
        for (unsigned i = 0; i < kPoints; ++i) {
            contexts[i] = blueContext(static_cast<int>(i) - 10, 7, 1, 3 * i);
        }
        contexts[0].sampleid = 0xffffffffu;
        contexts[1].sampleid = 0x80000001u;
    }

    static constexpr unsigned kPoints = 40;
    const BlueProgressive blue;
    SampleCtx contexts[kPoints];
    SampleCtx children[kPoints] = {};
    const RixRNG camera{contexts, kPoints, &blue};
};

TEST_F(BlueTest, ARixRNGDerivesAllKindsOfDomains) {
    const auto expectChildren = [&](auto expected) {
        for (unsigned i = 0; i < kPoints; ++i) expectEqual(children[i], expected(contexts[i]));
    };
    for (const unsigned n : {1u, 4u, 0u, 0x10001u}) {
        const auto split = [&](SampleCtx sc) { return newBlueDomainSplit(sc, kScramble, n); };
        RixRNG(camera, kScramble, children, RixRNG::Split{n});
        expectChildren(split);
        expectEqual(camera.NewDomainSplit(3, kScramble, n), split(contexts[3]));
    }
    const auto distrib = [&](SampleCtx sc) { return newBlueDomainDistrib(sc, kScramble, 6); };
    camera.NewDomainsDistrib(kScramble, 6, children);
    expectChildren(distrib);
    expectEqual(camera.NewDomainDistrib(0, kScramble, 6), distrib(contexts[0]));
    const unsigned indices[] = {9, 2};
    RixRNG(camera, kScramble, indices, 2, children);
    expectEqual(children[0], newBlueDomainSplit(contexts[9], kScramble, 1));
    expectEqual(children[1], newBlueDomainSplit(contexts[2], kScramble, 1));
}

TEST_F(BlueTest, CameraContextIsBlue) {
    const RandomGenerator random;
    for (int i = -3; i < 3; ++i) {
        expectEqual(blue.CameraContext(70 * i, 5, 6, 7), blueContext(70 * i, 5, 6, 7));
        expectEqual(random.CameraContext(70 * i, 5, 6, 7), cameraContext(70 * i, 5, 0, 7, 6));
        const unsigned pattern = 0x12345678u + static_cast<unsigned>(i);
        EXPECT_EQ(blue.ParentPattern(deriveBluePattern(pattern, kScramble), kScramble), pattern);
        EXPECT_EQ(random.ParentPattern(derivePattern(pattern, kScramble), kScramble), pattern);
    }
}

TEST_F(BlueTest, SplitsMultiplySampleidsModulo32Bits) {
    EXPECT_EQ(newBlueDomainSplit({1, 3}, kScramble, 4).sampleid, 12u);
    EXPECT_EQ(newBlueDomainSplit({1, 0xffffffffu}, kScramble, 4).sampleid, 0xfffffffcu);
    EXPECT_EQ(newBlueDomainSplit({1, 5}, kScramble, 0).sampleid, 0u);
}

// ---- what is drawn

TEST_F(BlueTest, DomainsDrawPaddedOrFromTheirSlot) {
    const auto expectDraws = [](const RixRNG& rng, auto sample) {
        Float3 xis[kPoints];
        rng.DrawSamples3D(xis);
        for (unsigned i = 0; i < kPoints; ++i) {
            const Float3 expected = sample(rng.sampleCtxArray[i]);
            EXPECT_EQ(xis[i], expected) << i;
            EXPECT_EQ(rng.DrawSample1D(i), expected.z);
            EXPECT_EQ(rng.DrawSample2D(i), Float2(expected.x, expected.y));
        }
    };
    const auto padded = [](SampleCtx sc) { return blueSample3D(sc.patternid, sc.sampleid); };
    const auto slot = [](unsigned d, unsigned split) {
        return [=](SampleCtx sc) { return blueSlotSample3D(sc.patternid, sc.sampleid, d, split); };
    };
    expectDraws(camera, padded);
    expectDraws(RixRNG(camera, kScramble, children), padded);
    expectDraws(RixRNG(camera, jointScramble(16), children), padded);
    expectDraws(RixRNG(camera, jointScramble(5), children), slot(5, 1));
    expectDraws(RixRNG(camera, jointScramble(5), children, RixRNG::Split{12}), slot(5, 12));
    expectDraws(RixRNG(camera, jointScramble(5), children, RixRNG::Split{257}), padded);
    expectDraws(RixRNG(camera, jointScramble(5), children, RixRNG::Distrib{0}), padded);
    const RixRNG split(camera, kScramble, children, RixRNG::Split{4});
    SampleCtx below[kPoints];
    expectDraws(RixRNG(split, jointScramble(2), below), slot(2, 4));
    expectDraws(RixRNG(split, contexts, kPoints), padded);
}

TEST_F(BlueTest, CamerasContextsAreDrawnWithoutARixRNG) {
    for (unsigned i = 0; i < kPoints; ++i) {
        const Float3 expected = camera.DrawSample3D(i);
        EXPECT_EQ(blue.Sample3D(contexts[i], 0), expected);
        EXPECT_EQ(blue.Sample2D(contexts[i], 0), Float2(expected.x, expected.y));
        EXPECT_EQ(blue.Sample1D(contexts[i], 0), expected.z);
    }
}

// Tiles, batches and other pixels make no difference, so a part of a picture, and what lies around
// it, has the samples of the whole.
TEST_F(BlueTest, ACropHasTheSamplesOfTheImage) {
    constexpr int kWidth = 150, kHeight = 90;
    const auto draw = [&](int left, int top, int width, int height) {
        std::vector<SampleCtx> sc;
        for (int y = top; y < top + height; ++y) {
            for (int x = left; x < left + width; ++x) sc.push_back(blueContext(x, y, 8, 2));
        }
        const auto n = static_cast<unsigned>(sc.size());
        const RixRNG rng(sc, n, &blue);
        const RixRNG split(rng, kScramble, sc, RixRNG::Split{3});
        const RixRNG slot(split, jointScramble(1), sc);
        std::vector<Float3> xis(n);
        slot.DrawSamples3D(xis);
        return xis;
    };
    const std::vector<Float3> whole = draw(-20, -30, kWidth, kHeight);
    const std::vector<Float3> crop = draw(-3, 5, 100, 40);
    for (std::size_t i = 0; i < crop.size(); ++i) {
        const std::size_t x = i % 100 + 17, y = i / 100 + 35;
        ASSERT_EQ(crop[i], whole[y * kWidth + x]);
    }
}

TEST_F(BlueTest, SamplesAtTheEndAreInTheUnitCubeAndDiffer) {
    for (const unsigned slot : {0u, 7u, 15u, kJointSlots}) {
        for (const unsigned splits : {1u, 3u, 256u}) {
            Order order;
            order.slot = static_cast<uint16_t>(slot);
            order.splits = static_cast<uint16_t>(splits);
            Float3 last{};
            for (unsigned s = 0; s < 1000; ++s) {
                const Float3 xi = blue.OrderedSample3D({0x12345678u, 500u - s}, 0, order);
                for (const float value : {xi.x, xi.y, xi.z}) {
                    ASSERT_GE(value, 0.0f);
                    ASSERT_LT(value, 1.0f);
                }
                // 2^32 is no multiple of 3, and the last visit has one branch.
                const bool mayRepeat = splits == 3 && 500u - s == 0xffffffffu;
                ASSERT_TRUE(mayRepeat || xi != last) << s;
                last = xi;
            }
        }
    }
}

TEST(BlueDeathTest, AnOrderWithoutMeaningEndsTheProgram) {
    const BlueProgressive blue;
    Order order;
    order.slot = kJointSlots + 1;
    EXPECT_DEATH(blue.OrderedSample1D({}, 0, order), "there are slots 0 to 15");
    order.slot = 3;
    order.splits = 0;
    EXPECT_DEATH(blue.OrderedSample1D({}, 0, order), "splits by 1 to 256");
}

} // namespace
} // namespace wellstrat::test
