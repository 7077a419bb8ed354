// SPDX-License-Identifier: Apache-2.0
//
// Camera contexts: no two pixels of a frame alike, along any path of domains; nothing slides or
// repeats.

#include "wellstrat/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace {

using namespace wellstrat;

constexpr int kSide = 4096; // 2^24 pixels

template <typename Pattern>
std::vector<uint32_t> patternsOfFrame(int first, Pattern pattern) {
    std::vector<uint32_t> patterns;
    patterns.reserve(std::size_t{kSide} * kSide);
    for (int y = first; y < first + kSide; ++y) {
        for (int x = first; x < first + kSide; ++x) patterns.push_back(pattern(x, y));
    }
    return patterns;
}

/// Marks the words in a bitmap, an eighth of all words at a time to save memory.
bool allDistinct(const std::vector<uint32_t>& words) {
    constexpr unsigned kSliceBits = 29;
    std::vector<bool> seen;
    for (uint32_t slice = 0; slice < 8; ++slice) {
        seen.assign(std::size_t{1} << kSliceBits, false);
        for (const uint32_t word : words) {
            if (word >> kSliceBits != slice) continue;
            auto bit = seen[word & ((1u << kSliceBits) - 1)];
            if (bit) return false;
            bit = true;
        }
    }
    return true;
}

TEST(Camera, TheTestSeesOneRepeatInAFrame) {
    std::vector<uint32_t> patterns =
        patternsOfFrame(0, [](int x, int y) { return cameraContext(x, y, 0, 0).patternid; });
    patterns[12345678] = patterns[3];
    EXPECT_FALSE(allDistinct(patterns));
}

TEST(Camera, PixelsOfAFrameDifferWithNegativeCoordinatesToo) {
    for (const unsigned seed : {0u, 3u}) {
        EXPECT_TRUE(allDistinct(patternsOfFrame(
            -kSide / 2, [=](int x, int y) { return cameraContext(x, y, 17, 0, seed).patternid; })));
    }
}

// A hash that is no bijection of the pattern would make about 32000 pairs of pixels meet at every
// step of the path, and each pair would stay together from there on.
TEST(Camera, AChildsPatternNeverEqualsAnotherPixelsAlongTheSamePath) {
    EXPECT_TRUE(allDistinct(patternsOfFrame(0, [](int x, int y) {
        SampleCtx sc = cameraContext(x, y, 1, 5);
        sc = sc.NewDomain(kLensScramble);
        sc = sc.NewDomainSplit(static_cast<Scramble>(0x2d96c92bu), 4);
        sc = sc.NewDomainDistrib(static_cast<Scramble>(0x3917fe2eu), 0);
        sc = sc.NewDomain(static_cast<Scramble>(0));
        return sc.NewDomain(static_cast<Scramble>(0xffffffffu)).patternid;
    })));
}

// Patterns that slide by a pixel a frame show as noise that swims over the image.
TEST(Camera, FramesDoNotSlide) {
    for (int f = 1; f <= 32; ++f) {
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 128; ++x) {
                const unsigned pattern = cameraContext(x, y, static_cast<unsigned>(f), 0).patternid;
                for (int dy : {-f, 0, f}) {
                    for (int dx : {-f, 0, f}) {
                        ASSERT_NE(pattern, cameraContext(x + dx, y + dy, 0, 0).patternid)
                            << "pixel " << x << ", " << y << ", frame " << f;
                    }
                }
            }
        }
    }
}

TEST(Camera, CoordinatesCountModulo65536) {
    for (int x : {-65536, -1, 0, 1, 40000}) {
        EXPECT_EQ(cameraContext(x, 3, 2, 0).patternid, cameraContext(x + 65536, 3, 2, 0).patternid);
        EXPECT_EQ(cameraContext(3, x, 2, 0).patternid, cameraContext(3, x + 65536, 2, 0).patternid);
    }
    EXPECT_NE(cameraContext(0, 1, 0, 0).patternid, cameraContext(65536 / 2, 0, 0, 0).patternid);
    EXPECT_NE(cameraContext(1, 0, 0, 0).patternid, cameraContext(0, 1, 0, 0).patternid);
}

TEST(Camera, SamplesOfAPixelShareItsPatternAndCountUp) {
    for (unsigned sampleid : {0u, 1u, 4096u, 0xffffffffu}) {
        const SampleCtx sc = cameraContext(7, 8, 9, sampleid);
        EXPECT_EQ(sc.patternid, cameraContext(7, 8, 9, 0).patternid);
        EXPECT_EQ(sc.sampleid, sampleid);
    }
}

// Guards against a frame key that is also some domain's: the pixels of one frame would then be a
// domain of another's.
TEST(Camera, TheReadyMadeDomainsOfAPixelAllDiffer) {
    static_assert(kPixelFilterScramble != kLensScramble, "");
    static_assert(kLensScramble != kTimeScramble, "");
    static_assert(kTimeScramble != kPixelFilterScramble, "");
    for (unsigned frame = 0; frame < 1000; ++frame) {
        const SampleCtx sc = cameraContext(100, 200, frame, 0);
        const unsigned filter = sc.NewDomain(kPixelFilterScramble).patternid;
        const unsigned lens = sc.NewDomain(kLensScramble).patternid;
        const unsigned time = sc.NewDomain(kTimeScramble).patternid;
        ASSERT_TRUE(filter != lens && lens != time && time != filter && sc.patternid != lens);
        ASSERT_NE(sc.NewDomain(static_cast<Scramble>(frame)).patternid,
                  cameraContext(100, 200, frame + 1, 0).patternid);
    }
}

TEST(Camera, SeedZeroChangesNothing) {
    for (unsigned frame : {0u, 1u, 0xffffffffu}) {
        EXPECT_EQ(cameraContext(5, 6, frame, 7, 0).patternid,
                  cameraContext(5, 6, frame, 7).patternid);
        EXPECT_EQ(cameraContext(5, 6, frame, 7, 8).sampleid, 7u);
    }
}

// Guards against a seed that is part of the frame's key: the image of one frame and seed would be
// that of another frame and seed. 2^20 images, by two pixels each: with 32 bits of key for all
// frames and seeds, some 128 pairs would be equal. That two of these are is a chance of 10^-7.
TEST(Camera, FramesAndSeedsNeverAlias) {
    constexpr unsigned kFrames = 16, kSeeds = 65536;
    std::vector<uint64_t> images;
    for (unsigned frame = 0; frame < kFrames; ++frame) {
        for (unsigned seed = 0; seed < kSeeds; ++seed) {
            images.push_back(uint64_t{cameraContext(0, 0, frame, 0, seed).patternid} << 32 |
                             cameraContext(1, 0, frame, 0, seed).patternid);
        }
    }
    std::sort(images.begin(), images.end());
    EXPECT_EQ(std::adjacent_find(images.begin(), images.end()), images.end());
}

/// The pattern of a pixel of image i.
using Image = unsigned (*)(int x, int y, unsigned i);

/// Two images of n pixels share about n^2 / 2^32 patterns, as any two sets of random words do.
void expectNoMoreSharedThanByChance(unsigned images, Image image) {
    constexpr int width = 480, height = 270;
    std::vector<unsigned> previous, current;
    for (unsigned i = 0; i < images; ++i) {
        current.clear();
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) current.push_back(image(x, y, i));
        }
        std::sort(current.begin(), current.end());
        std::vector<unsigned> shared;
        std::set_intersection(previous.begin(), previous.end(), current.begin(), current.end(),
                              std::back_inserter(shared));
        // 3.9 are expected. More than 30 come by chance once in 10^15 pairs.
        ASSERT_LT(shared.size(), 30u) << "images " << i - 1 << " and " << i;
        previous.swap(current);
    }
}

// A hash whose keys act too simply lets some pairs of frames share thousands: noise that comes
// back.
TEST(Camera, FramesShareNoMorePatternsThanByChance) {
    expectNoMoreSharedThanByChance(
        240, [](int x, int y, unsigned i) { return cameraContext(x, y, i, 0).patternid; });
}

TEST(Camera, SeedsShareNoMorePatternsThanByChance) {
    expectNoMoreSharedThanByChance(
        120, [](int x, int y, unsigned i) { return cameraContext(x, y, 1, 0, i).patternid; });
    expectNoMoreSharedThanByChance(
        120, [](int x, int y, unsigned i) { return cameraContext(x, y, i, 0, i).patternid; });
}

} // namespace
