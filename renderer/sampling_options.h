// SPDX-License-Identifier: Apache-2.0
//
// How samples are taken and used.

#pragma once

#include "wellstrat/generator.h"

namespace wellstrat::render {

/// Which samples count for light that both light samples and bxdf samples can find: both, weighted
/// by multiple importance sampling, or one kind alone. All have the same mean.
enum class Strategy { both, lights, bxdf };

struct SamplingOptions {
    const Generator* generator = nullptr; ///< null: the tables
    unsigned seed = 0;                    ///< of the camera's contexts: another one, other noise
    unsigned depth = 5;                   ///< bounces of indirect light; 0: direct light only
    unsigned split = 1;   ///< light samples at the first hit, at least 1, by splitting
    bool distrib = false; ///< later hits take light samples by distribution: of `split`, the part
                          ///< that their throughput is worth, but at least 1
    Strategy strategy = Strategy::both;
    bool background = true; ///< camera rays that meet nothing see the environment; else they are
                            ///< black, and count as transparent
};

} // namespace wellstrat::render
