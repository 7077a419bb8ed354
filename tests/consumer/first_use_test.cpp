// SPDX-License-Identifier: Apache-2.0
//
// The first draw of a process, which builds the tables or needs none. Many threads make it at once.
// Each test below needs a process of its own; ctest gives it one. Run under the thread sanitizer
// too, which sees what the values cannot show.

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/long.h"
#include "wellstrat/tables.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace {

constexpr unsigned kThreads = 64;

/// Runs function(thread) in 64 threads that start together.
template <typename Function>
void race(Function function) {
    std::atomic<unsigned> ready{0};
    std::vector<std::thread> threads;
    for (unsigned thread = 0; thread < kThreads; ++thread) {
        threads.emplace_back([&ready, &function, thread] {
            ++ready;
            while (ready.load() < kThreads) std::this_thread::yield();
            function(thread);
        });
    }
    for (std::thread& thread : threads) thread.join();
}

// Guards against tables that are seen before they are complete.
TEST(FirstUse, ScalarDrawsRace) {
    ASSERT_EQ(wellstrat::detail::tableWords.load(), nullptr) << "the tables exist already";
    RtFloat3 drawn[kThreads];
    race([&](unsigned thread) {
        // The last group of a block: what a thread that builds the tables writes last.
        drawn[thread] = wellstrat::sample3D(thread, wellstrat::kTableSize - 1 - thread);
    });
    for (unsigned thread = 0; thread < kThreads; ++thread) {
        EXPECT_EQ(drawn[thread], wellstrat::sample3D(thread, wellstrat::kTableSize - 1 - thread));
    }
}

// The same for the compiled batch functions, which also choose their instruction set then.
TEST(FirstUse, BatchDrawsRace) {
    ASSERT_EQ(wellstrat::detail::tableWords.load(), nullptr) << "the tables exist already";
    constexpr unsigned kPoints = 100;
    std::vector<RtFloat2> drawn(kThreads * kPoints);
    race([&](unsigned thread) {
        std::vector<RixRNG::SampleCtx> contexts(kPoints);
        for (unsigned i = 0; i < kPoints; ++i) contexts[i] = {thread, 4095u - i};
        RixRNG(contexts.data(), kPoints).DrawSamples2D(&drawn[std::size_t{thread} * kPoints]);
    });
    for (unsigned thread = 0; thread < kThreads; ++thread) {
        for (unsigned i = 0; i < kPoints; ++i) {
            ASSERT_EQ(drawn[thread * kPoints + i], wellstrat::sample2D(thread, 4095u - i));
        }
    }
}

// buildTables gives every caller the same tables.
TEST(FirstUse, ExplicitBuildsRace) {
    ASSERT_EQ(wellstrat::detail::tableWords.load(), nullptr) << "the tables exist already";
    const uint32_t* built[kThreads];
    race([&](unsigned thread) { built[thread] = wellstrat::buildTables(); });
    for (const uint32_t* words : built) EXPECT_EQ(words, wellstrat::tables());
}

// Draws all that there is through RixRNGs of this generator, from few and from many points.
void expectNoTables(const RixRNG::Generator& generator) {
    constexpr unsigned kPoints = 100;
    std::vector<RixRNG::SampleCtx> contexts(kPoints), children(kPoints);
    std::vector<RtFloat3> xis(kPoints);
    for (unsigned i = 0; i < kPoints; ++i) contexts[i] = generator.CameraContext(9, 7, 1, i);
    for (const unsigned n : {3u, kPoints}) {
        const RixRNG camera(contexts.data(), n, &generator);
        const RixRNG slot(camera, wellstrat::jointScramble(2), children, RixRNG::Split{2});
        for (const RixRNG& rng : {camera, slot}) {
            rng.DrawSamples3D(xis);
            EXPECT_EQ(rng.DrawSample3D(n - 1), xis[n - 1]);
        }
    }
    EXPECT_EQ(wellstrat::detail::tableWords.load(), nullptr) << "12 MiB, and milliseconds";
}

TEST(FirstUse, LongSamplesNeedNoTables) { expectNoTables(wellstrat::LongProgressive()); }
TEST(FirstUse, BlueSamplesNeedNoTables) { expectNoTables(wellstrat::BlueProgressive()); }

} // namespace
