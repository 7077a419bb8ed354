// SPDX-License-Identifier: Apache-2.0
//
// Scenarios that draw all points of a domain. What a domain is, a function says: it makes n
// contexts that have something in common, and a view of them to draw from.

#pragma once

#include "scenarios.h"

#include <functional>

namespace wellstrat {

using MakeDomain =
    std::function<RixRNG(std::vector<SampleCtx>& contexts, std::size_t n, Access access)>;

/// One of a camera's contexts.
inline MakeDomain cameraDomain(const Generator* generator = nullptr) {
    return [generator](std::vector<SampleCtx>& contexts, std::size_t n, Access access) {
        contexts = makeContexts(n, access);
        return RixRNG(contexts.data(), static_cast<unsigned>(n), generator);
    };
}

/// A new domain of `contexts`, in their place, at the sampleids that they have.
inline RixRNG deriveInPlace(std::vector<SampleCtx>& contexts, const Generator& generator,
                            Scramble scramble, unsigned split) {
    const std::vector<SampleCtx> parents = contexts;
    const RixRNG camera(contexts.data(), static_cast<unsigned>(contexts.size()), &generator);
    const RixRNG domain(camera, scramble, contexts.data(), RixRNG::Split{split});
    for (std::size_t i = 0; i < contexts.size(); ++i) contexts[i].sampleid = parents[i].sampleid;
    return domain;
}

/// Single draws from 1024 points.
template <typename Draw>
void addSingle(const std::string& name, Access access, const MakeDomain& make, Draw draw) {
    addScenario(name, {}, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts;
        const RixRNG rng = make(contexts, 1024, access);
        drawEach(state, caches, contexts, access, rng, draw);
    });
}

/// Rounds of as few single draws as small batches have, which with cluttered caches is what to
/// compare them with.
inline void addRounds(const std::string& name, const MakeDomain& make) {
    addScenario(name, {16, 256}, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts;
        const auto n = static_cast<std::size_t>(state.range(0));
        const RixRNG rng = make(contexts, n, Access::coherent);
        drawEach(state, caches, contexts, Access::coherent, rng, kDraw2D);
    });
}

/// Batches of these sizes, on each target.
template <typename DrawAll>
void addBatch(const std::string& name, const std::vector<int64_t>& sizes, Access access,
              const MakeDomain& make, DrawAll draw) {
    addBatches(name, sizes, [=](benchmark::State& state, Caches caches) {
        std::vector<SampleCtx> contexts;
        const RixRNG rng = make(contexts, static_cast<std::size_t>(state.range(0)), access);
        drawAll(state, caches, contexts, access, rng, draw);
    });
}

} // namespace wellstrat
