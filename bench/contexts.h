// SPDX-License-Identifier: Apache-2.0
//
// The sample contexts that the benchmarks draw from.

#pragma once

#include "RixRNG.h"

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

/// From one round of draws to the next: coherent contexts step on by one sample, as a progressive
/// renderer does.
inline void stepContexts(std::vector<SampleCtx>& contexts, Access access) {
    if (access != Access::coherent) return;
    for (SampleCtx& sc : contexts) sc.sampleid = (sc.sampleid + 1) % 4096;
}

} // namespace wellstrat
