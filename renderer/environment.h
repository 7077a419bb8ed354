// SPDX-License-Identifier: Apache-2.0
//
// Light from infinitely far away, and directions to where it is bright.

#pragma once

#include "discrete_distribution.h"
#include "scene.h"

#include <vector>

namespace wellstrat::render {

/// An environment of a scene, which must outlive this. Immutable; safe in any thread.
///
/// Directions are chosen pixel by pixel of the map, by brightness times solid angle, and evenly
/// within a pixel. The two sample coordinates stay apart: y chooses the row, x the column, and what
/// is left of both is the place in the pixel.
class EnvironmentLight {
public:
    explicit EnvironmentLight(const Environment& environment);

    /// What comes from there; `direction` has unit length.
    Float3 radiance(Float3 direction) const;

    /// Whether `sample` may be called. Not for a constant environment, for which directions of the
    /// bxdf are better, nor for a black one.
    bool canSample() const { return rows_.total() > 0.0; }

    /// A direction to the environment, and its density per unit solid angle.
    Float3 sample(Float2 xi, float& pdf) const;

    /// The density of `sample`; 0 if it may not be called.
    float pdf(Float3 direction) const;

private:
    unsigned width() const { return environment_.map->width(); }
    unsigned height() const { return environment_.map->height(); }
    float pixelPdf(std::size_t row, std::size_t column) const;

    Float2 mapPosition(Float3 direction) const;

    const Environment& environment_;
    float turn_;                ///< the part of a whole turn by which the map is turned, in [0, 1)
    std::vector<double> edges_; ///< the heights y of the upper edges of the rows, and of the lowest
    DiscreteDistribution rows_;
    std::vector<DiscreteDistribution> columns_; ///< of each row
};

} // namespace wellstrat::render
