// SPDX-License-Identifier: Apache-2.0
//
// Debug builds catch a slot that is taken twice on a path, and nothing else.

#include "RixRNG.h"
#include "wellstrat/joint.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace wellstrat {
namespace {

constexpr Scramble kHit{0x03707344};

class SlotWatch : public testing::Test {
protected:
    void SetUp() override {
#ifdef NDEBUG
        GTEST_SKIP() << "the library watches slots in debug builds only";
#endif
        GTEST_FLAG_SET(death_test_style, "threadsafe");
    }

    const JointProgressive joint;
    SampleCtx camera[3] = {{11, 0}, {22, 0}, {33, 5}}, hits[3] = {}, domain[3] = {};
    Float2 xi[3];

    /// Draws slot 5 of the camera and, at a hit, this one.
    void draw(unsigned slot, const Generator* generator, unsigned split = 1) {
        const RixRNG rng(camera, 3, generator);
        RixRNG(rng, jointScramble(5), domain, RixRNG::Split{split}).DrawSamples2D(xi);
        RixRNG(RixRNG(rng, kHit, hits), jointScramble(slot), domain).DrawSamples2D(xi);
    }
};

using SlotWatchDeathTest = SlotWatch;

TEST_F(SlotWatchDeathTest, EndsTheProgramAndNamesBothDomains) {
    EXPECT_DEATH(draw(5, &joint),
                 "^wellstrat: slot 5 is drawn twice on a path: by camera > 0x6a6f6973 .slot 5. and "
                 "by camera > 0x03707344 > 0x6a6f6973 .slot 5.\n$");
}

TEST_F(SlotWatchDeathTest, SeesDrawsOfOnePoint) {
    const RixRNG rng(camera, 3, &joint);
    const RixRNG slot(rng, jointScramble(15), domain);
    const RixRNG hit(RixRNG(rng, kHit, hits, RixRNG::Split{4}), jointScramble(15), hits);
    slot.DrawSample1D(0);
    hit.DrawSample2D(1);
    slot.DrawSample3D(2);
    EXPECT_DEATH(hit.DrawSample1D(0), "slot 15 is drawn twice on a path");
    EXPECT_DEATH(hit.DrawSample2D(2), "slot 15 is drawn twice on a path");
    EXPECT_DEATH(slot.DrawSample3D(1), "slot 15 is drawn twice on a path");
}

TEST_F(SlotWatch, LetsSlotsBeDrawnAgain) {
    draw(6, &joint);
    draw(6, &joint);
    draw(6, &joint, 4); // of another picture
}

TEST_F(SlotWatch, LetsOtherObjectsAssignSlotsAnew) {
    for (int i = 0; i < 4; ++i) {
        const JointProgressive other; // perhaps at the address of the last one
        if (i % 2 == 0) {
            draw(1, &other);
            continue;
        }
        const RixRNG rng(camera, 3, &other);
        RixRNG(RixRNG(rng, kHit, hits), jointScramble(5), domain).DrawSamples2D(xi);
    }
}

TEST_F(SlotWatch, LetsSlotsBeWhereTheyHaveNoMeaning) {
    const RixRNG rng(camera, 3, &joint);
    RixRNG(rng, jointScramble(5), domain).DrawSamples2D(xi);
    const RixRNG distributed(rng, kHit, hits, RixRNG::Distrib{0});
    RixRNG(distributed, jointScramble(5), domain).DrawSamples2D(xi);
}

TEST_F(SlotWatch, LetsThreadsDrawAtOnce) {
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < 4; ++t) {
        threads.emplace_back([this, t] {
            for (unsigned s = 0; s < 200; ++s) {
                SampleCtx pixel{t % 2, s}, hit, slot;
                const RixRNG rng(&pixel, 1, &joint);
                RixRNG(rng, jointScramble(0), &slot).DrawSample2D(0);
                RixRNG(RixRNG(rng, kHit, &hit), jointScramble(1), &slot).DrawSample2D(0);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

/// Children may outlive the object that made them.
TEST_F(SlotWatch, WatchesOrphans) {
    const Generator* child = JointProgressive().ForChild(jointScramble(3), 1);
    const Generator* again = JointProgressive().ForChild(jointScramble(3), 1);
    EXPECT_NE(child, again);
    EXPECT_EQ(child->Sample1D({1, 2}, 0), again->Sample1D({1, 2}, 0));
}

} // namespace
} // namespace wellstrat
