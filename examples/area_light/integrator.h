// SPDX-License-Identifier: Apache-2.0
//
// A small direct-light integrator that takes all its samples through RixRNG. Start reading at
// `renderRow` in integrator.cpp.

#pragma once

#include "RixRNG.h"

#include <vector>

namespace area_light {

/// How the samples at a hit point follow from those of the camera ray.
enum class Branching {
    plain,       ///< one bxdf and one light sample for each camera ray
    split,       ///< kBranches of each, from one sequence for the pixel
    distribution ///< kBranches of each, from a new sequence for each camera ray
};

constexpr unsigned kBranches = 4;

/// The bxdf and light samples that one camera ray leads to.
constexpr unsigned branchCount(Branching branching) {
    return branching == Branching::plain ? 1 : kBranches;
}

struct RenderSettings {
    unsigned size;            ///< width and height in pixels
    unsigned samplesPerPixel; ///< light samples; a multiple of branchCount(branching)
    Branching branching;
    const RixRNG::Generator* generator; ///< null: the tables
    unsigned frame;                     ///< frames have independent samples
    unsigned threads;                   ///< does not change the image
};

/// RGB radiance, row by row from the top.
using Image = std::vector<RtFloat3>;

/// Renders the scene of scene.h.
Image render(const RenderSettings& settings);

/// The root of the mean squared difference over all pixels and channels.
double rmse(const Image& a, const Image& b);

} // namespace area_light
