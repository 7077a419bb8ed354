// SPDX-License-Identifier: Apache-2.0

#include "sampler.h"

RtFloat2 sampleOf(unsigned patternid, unsigned i) {
    RixRNG::SampleCtx context{patternid, i};
    RtFloat2 xi;
    RixRNG(&context, 1).DrawSamples2D(&xi);
    return xi;
}
