// SPDX-License-Identifier: Apache-2.0
//
// A pixel of ../area_light as one function: what a thread of a GPU computes. The samples come by
// functions of the tables and a context, where the CPU's integrator has batches and a RixRNG.

#pragma once

#include "../area_light/estimates.h"
#include "wellstrat/camera.h"
#include "wellstrat/lookup.h"

namespace area_light {

/// The radiance of pixel (x, y) of size x size pixels, by as many samples of the light and of the
/// sky. `words` are the words of the tables (wellstrat/tables.h, or of a DeviceTables).
WELLSTRAT_HOST_DEVICE inline RtFloat3 renderPixel(const uint32_t* words, unsigned size, unsigned x,
                                                  unsigned y, unsigned samples) {
    const auto draw = [words](wellstrat::SampleCtx domain) {
        return wellstrat::sample2D(words, domain.patternid, domain.sampleid);
    };
    const RtFloat2 corner{static_cast<float>(x), static_cast<float>(y)};
    RtFloat3 sum(0.0f);
    for (unsigned sampleid = 0; sampleid < samples; ++sampleid) {
        const wellstrat::SampleCtx camera =
            wellstrat::cameraContext(static_cast<int>(x), static_cast<int>(y), 0, sampleid);
        const RtFloat2 inPixel = draw(camera.NewDomain(wellstrat::kPixelFilterScramble));
        Hit hit;
        if (!intersect(cameraRay((corner + inPixel) * (1.0f / static_cast<float>(size))), hit)) {
            continue;
        }
        sum += hit.albedo * lightEstimate(hit, draw(camera.NewDomain(kLightScramble)));
        sum += hit.albedo * skyEstimate(hit, draw(camera.NewDomain(kBxdfScramble)));
    }
    return sum * (1.0f / static_cast<float>(samples));
}

} // namespace area_light
