// SPDX-License-Identifier: Apache-2.0
//
// The sample contexts that the benchmarks draw from.

#pragma once

#include "RixRNG.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace wellstrat {

/// What the points of a batch have in common.
enum class Access {
    coherent,  ///< each its own pattern, all at one sampleid: progressive rendering
    random,    ///< each its own pattern and its own sampleid below 4096
    onePattern ///< the first samples of one pattern: all samples of a pixel at once
};

inline std::vector<SampleCtx> makeContexts(std::size_t n, Access access) {
    std::vector<SampleCtx> contexts(n);
    for (unsigned i = 0; i < n; ++i) {
        switch (access) {
        case Access::coherent: contexts[i] = {HashToUnsigned(1, i), 0}; break;
        case Access::random:
            contexts[i] = {HashToUnsigned(1, i), HashToUnsigned(2, i) % 4096};
            break;
        case Access::onePattern: contexts[i] = {HashToUnsigned(1, 0), i}; break;
        }
    }
    return contexts;
}

/// Reports nanoseconds per item, of which each iteration makes `items`. The script reads the
/// counter, which is the inverse of a rate in 10^9 items a second.
inline void reportItems(benchmark::State& state, std::size_t items) {
    using benchmark::Counter;
    state.counters["ns"] =
        Counter(static_cast<double>(state.iterations()) * static_cast<double>(items) * 1e-9,
                Counter::kIsRate | Counter::kInvert);
}

} // namespace wellstrat
