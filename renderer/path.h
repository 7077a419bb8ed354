// SPDX-License-Identifier: Apache-2.0
//
// A batch of paths on their way through the scene, all at the same bounce.

#pragma once

#include "bxdf.h"
#include "geometry.h"
#include "medium.h"

#include <RixRNG.h>

namespace wellstrat::render {

/// A tile of 16 x 16 pixels at one sample each.
constexpr unsigned kBatchSize = 256;

struct Path {
    unsigned point;             ///< which of the batch's results it adds to
    Ray ray;                    ///< the last one
    MediumPtr medium = nullptr; ///< in which it goes
    Float3 throughput = Float3(1.0f);
    /// How else the light that the ray finds might have been found: the pdf of the ray's direction,
    /// and the number of light samples where it began. 0 for camera rays, which have no rival.
    float bxdfPdf = 0.0f;
    unsigned lightSamples = 0;
};

/// Where a path scatters.
struct Vertex {
    SurfacePoint point;
    Bxdf bxdf;
    MediumPtr behind; ///< what light goes through that passes
};

/// The medium from a vertex of a path into a direction.
inline MediumPtr mediumTowards(Float3 direction, const Path& path, const Vertex& vertex) {
    return vertex.bxdf.passes(direction) ? vertex.behind : path.medium;
}

/// The memory of a batch. Entry i of each array belongs to the same path. Paths that go on move to
/// the front (compaction.h), so that contexts stay contiguous as the RixRNG wants them.
struct PathBatch {
    Path paths[kBatchSize];
    Vertex vertices[kBatchSize];
    RixRNG::SampleCtx contexts[kBatchSize]; ///< of the camera, then of the last hit
    bool meetsNothing[kBatchSize];          ///< of the camera rays, in the order of the results

    // For one domain at a time:
    RixRNG::SampleCtx domain[kBatchSize];
    RtFloat2 xi[kBatchSize];
};

} // namespace wellstrat::render
