// SPDX-License-Identifier: Apache-2.0
//
// The path tracer: what a camera sample is worth. README.md tours its sampling structure.

#pragma once

#include "camera.h"
#include "direct_light.h"
#include "geometry.h"
#include "path.h"
#include "pixel_filter.h"
#include "sampling_options.h"

#include <cstdint>
#include <vector>

namespace wellstrat::render {

/// Which sample of which pixel.
struct CameraSample {
    unsigned x, y; ///< from the upper left corner
    unsigned sampleid;
};

/// Traces paths through a scene, which must outlive this. All but setCamera is safe in any thread.
class Integrator {
public:
    Integrator(const Scene& scene, unsigned width, unsigned height, const SamplingOptions& options);

    /// Rays start from `camera` from now on. Not while `radiance` runs.
    void setCamera(const PictureCamera& camera) { camera_ = camera; }

    /// Writes the radiance of `count` samples, at most kBatchSize, to `results`. Each depends on
    /// nothing but the scene, the options and the sample. `batch` is memory to work in, and says
    /// afterwards which camera rays meet nothing. Returns the
    /// number of rays traced, those of camera and bounces, not those to lights.
    uint64_t radiance(unsigned count, const CameraSample* samples, PathBatch& batch,
                      Float3* results) const;

private:
    void startPaths(const RixRNG& camera, const CameraSample* samples, PathBatch& batch) const;
    unsigned findHits(unsigned count, unsigned bounce, PathBatch& batch, Float3* results) const;
    Vertex vertexAt(const Path& path, const Surface& surface) const;
    unsigned scatter(const RixRNG& hits, unsigned bounce, PathBatch& batch) const;

    SamplingOptions options_;
    PictureCamera camera_;
    PixelFilter filter_;
    Geometry geometry_;
    DirectLight directLight_;
    const Material* materials_;
    std::vector<BxdfParameters> uniform_; ///< of each material, as if it had no textures
};

} // namespace wellstrat::render
