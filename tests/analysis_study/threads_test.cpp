// SPDX-License-Identifier: Apache-2.0
//
// The parts of the analysis that the tool runs in several threads at once. Guards against shared
// state: the thread sanitizer sees it even where the results are right.

#include "wellstrat/analysis/convergence.h"
#include "wellstrat/analysis/spectrum.h"
#include "wellstrat/hash.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace wellstrat {
namespace {

constexpr unsigned kThreads = 4;

/// Calls work(t) for t in [0, kThreads), each in a thread of its own.
template <class Work>
void inThreads(const Work& work) {
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < kThreads; ++t) threads.emplace_back([&work, t] { work(t); });
    for (std::thread& thread : threads) thread.join();
}

/// FFTW makes its plans in one thread at a time.
TEST(Threads, SpectraAtOnce) {
    std::vector<double> values(128);
    for (uint32_t i = 0; i < 128; ++i) values[i] = hashPair(1, i) * 0x1p-32;
    const UnitPoints points(values.data(), 64, 2);
    std::vector<double> powers(kThreads);
    inThreads([&](unsigned t) {
        for (int highest = 5; highest < 15; ++highest) {
            Periodogram periodogram(highest);
            periodogram.add(points);
            powers[t] += periodogram.power(3, -4);
        }
    });
    for (const double power : powers) EXPECT_EQ(power, powers[0]);
}

/// Each thread has patterns of its own and draws first what another thread draws later.
TEST(Threads, StudiesAtOnce) {
    const Integrand f = makeIntegrand("disk*gaussian");
    const std::vector<uint32_t> counts{4, 64};
    std::vector<PointSourcePtr> sources;
    sources.push_back(generatorSource(nullptr));
    sources.push_back(sobolSource(SobolRandomization::owen));
    sources.push_back(haltonSource());
    sources.push_back(jitteredSource());
    for (const PointSourcePtr& source : sources) {
        std::vector<std::vector<ErrorSums>> sums(kThreads, std::vector<ErrorSums>(counts.size()));
        inThreads([&](unsigned t) {
            for (unsigned k = 0; k < kThreads; ++k) {
                const uint64_t pattern = (t + k) % kThreads;
                addErrors(*source, {&f}, counts, {pattern, pattern + 1}, sums[t].data());
            }
        });
        for (const std::vector<ErrorSums>& same : sums) {
            EXPECT_EQ(same[1].second.words(), sums[0][1].second.words());
        }
    }
}

} // namespace
} // namespace wellstrat
