// SPDX-License-Identifier: Apache-2.0
//
// The samples that the tool draws.

#pragma once

#include "RixRNG.h"
#include "common/command_line/generators.h"
#include "wellstrat/analysis/unit_points.h"

#include <cstdint>

namespace wellstrat::cli {

/// Samples first to first + count - 1 of one pattern.
struct SampleRun {
    const NamedGenerator* generator;
    unsigned dims; ///< 1, 2 or 3
    uint32_t pattern;
    uint64_t first; ///< first + count is at most 2^32
    uint64_t count;
};

/// Draws the samples in order and calls visit(const float* coordinates) with each one's `dims`
/// coordinates.
template <typename Visitor>
void drawSamples(const SampleRun& run, Visitor&& visit) {
    SampleCtx context{run.pattern, static_cast<uint32_t>(run.first)};
    RixRNG rng(&context, 1, run.generator->generator);
    rng.order = run.generator->order;
    for (uint64_t i = 0; i < run.count; ++i) {
        float xi[3] = {};
        if (run.dims == 1) {
            xi[0] = rng.GenerateSample1D(0);
        } else if (run.dims == 2) {
            const Float2 xy = rng.GenerateSample2D(0);
            xi[0] = xy.x;
            xi[1] = xy.y;
        } else {
            const Float3 xyz = rng.GenerateSample3D(0);
            xi[0] = xyz.x;
            xi[1] = xyz.y;
            xi[2] = xyz.z;
        }
        visit(static_cast<const float*>(xi));
    }
}

/// The samples as a point set.
UnitPoints drawPoints(const SampleRun& run);

} // namespace wellstrat::cli
