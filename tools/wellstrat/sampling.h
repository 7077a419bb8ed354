// SPDX-License-Identifier: Apache-2.0
//
// The samples that the tool draws, by name of their generator.

#pragma once

#include "RixRNG.h"
#include "wellstrat/analysis/unit_points.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// A generator that --generator and --compare accept.
struct NamedGenerator {
    const char* name;
    const char* description;
    const Generator* generator; ///< as RixRNG takes it: null is the tables
    Order order = {};           ///< of the domain that is drawn
};

/// All of them.
const std::vector<NamedGenerator>& namedGenerators();

/// These, and slot 0 of the joint samples: of one domain there is nothing to choose.
const std::vector<NamedGenerator>& sampleGenerators();

/// The one of `among` called `name`. Throws CliError, which names `option` and all of them, if
/// there is none.
const NamedGenerator& findGenerator(const std::string& option, const std::string& name,
                                    const std::vector<NamedGenerator>& among = namedGenerators());

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
