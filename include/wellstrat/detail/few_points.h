// SPDX-License-Identifier: Apache-2.0
//
// The batches of a RixRNG: loops that compilers inline where there are few points, since a call of
// the vector code costs more than it gains there, and the functions of batch.h where there are
// more. The same bits either way.

#pragma once

#include "wellstrat/batch.h"
#include "wellstrat/lookup.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// Up to so many points are few (docs/performance.md).
constexpr unsigned kFewPoints = 7;

// The tables are built (lookup.h) for all draws, as each RixRNG without a generator sees to.

inline void drawSamples1D(unsigned n, const SampleCtx* contexts, float* xis) {
    if (n > kFewPoints) return wellstrat::drawSamples1D(n, contexts, xis);
    for (unsigned i = 0; i < n; ++i) {
        xis[i] = sample1D(wellstrat::builtTables(), contexts[i].patternid, contexts[i].sampleid);
    }
}

inline void drawSamples2D(unsigned n, const SampleCtx* contexts, Float2* xis) {
    if (n > kFewPoints) return wellstrat::drawSamples2D(n, contexts, xis);
    for (unsigned i = 0; i < n; ++i) {
        xis[i] = sample2D(wellstrat::builtTables(), contexts[i].patternid, contexts[i].sampleid);
    }
}

inline void drawSamples3D(unsigned n, const SampleCtx* contexts, Float3* xis) {
    if (n > kFewPoints) return wellstrat::drawSamples3D(n, contexts, xis);
    for (unsigned i = 0; i < n; ++i) {
        xis[i] = sample3D(wellstrat::builtTables(), contexts[i].patternid, contexts[i].sampleid);
    }
}

inline void newDomainsSplit(unsigned n, const SampleCtx* parents, Scramble scramble,
                            unsigned newnumsamples, SampleCtx* children) {
    if (n > kFewPoints) {
        return wellstrat::newDomainsSplit(n, parents, scramble, newnumsamples, children);
    }
    for (unsigned i = 0; i < n; ++i) {
        children[i] = parents[i].NewDomainSplit(scramble, newnumsamples);
    }
}

inline void newDomainsDistrib(unsigned n, const SampleCtx* parents, Scramble scramble,
                              unsigned newsampleid, SampleCtx* children) {
    if (n > kFewPoints) {
        return wellstrat::newDomainsDistrib(n, parents, scramble, newsampleid, children);
    }
    for (unsigned i = 0; i < n; ++i) {
        children[i] = parents[i].NewDomainDistrib(scramble, newsampleid);
    }
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
