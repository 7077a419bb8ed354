// SPDX-License-Identifier: Apache-2.0
//
// Light that arrives straight from lights and from the environment: by samples of them, and by
// bxdf samples that meet them by chance. Veach and Guibas 1995, "Optimally Combining Sampling
// Techniques for Monte Carlo Rendering", section 3, has the weights.

#pragma once

#include "environment.h"
#include "lights.h"
#include "path.h"
#include "sampling_options.h"

#include <optional>

namespace wellstrat::render {

/// The lights of a scene, which must outlive this, as must its geometry.
class DirectLight {
public:
    DirectLight(const Scene& scene, const Geometry& geometry, const SamplingOptions& options);

    /// Takes the light samples of the first hits (bounce 0) or later ones. `hits` has the contexts
    /// of batch.paths and batch.vertices. Adds to `results` by path, and sets the paths' counts.
    void sample(const RixRNG& hits, unsigned bounce, PathBatch& batch, Float3* results) const;

    /// What the path's last ray brings from a surface that it met.
    Float3 fromSurface(const Path& path, const Hit& hit, const Surface& surface) const;

    /// What it brings if it met nothing.
    Float3 fromEnvironment(const Path& path) const;

private:
    unsigned sampleCount(unsigned bounce, const Path& path) const;
    Float3 lightSample(const Path& path, const Vertex& vertex, Float2 xi) const;
    Float3 environmentSample(const Path& path, const Vertex& vertex, Float2 xi) const;

    const Geometry& geometry_;
    const SamplingOptions options_;
    Lights lights_;
    std::optional<EnvironmentLight> environment_;
};

} // namespace wellstrat::render
