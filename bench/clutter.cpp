// SPDX-License-Identifier: Apache-2.0

#include "clutter.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wellstrat {
namespace {

constexpr std::size_t kBytes = std::size_t{96} << 20;
constexpr std::size_t kLine = 64;

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

/// Seconds between two readings of the clock that follow each other at once, at least.
double clockCost() {
    double cost = 1;
    for (int i = 0; i < 1000; ++i) {
        const double first = now();
        cost = std::min(cost, now() - first);
    }
    return cost;
}

} // namespace

void clutterCaches() {
    static std::vector<uint64_t> scene(kBytes / sizeof(uint64_t), 1);
    for (std::size_t i = 0; i < scene.size(); i += kLine / sizeof(uint64_t)) ++scene[i];
    benchmark::DoNotOptimize(scene.data());
    benchmark::ClobberMemory();
}

void Stopwatch::start() {
    now(); // brings the clock's own code and data into the caches
    start_ = now();
}

double Stopwatch::stop() const {
    const double time = now() - start_;
    static const double cost = clockCost();
    return time - cost;
}

} // namespace wellstrat
