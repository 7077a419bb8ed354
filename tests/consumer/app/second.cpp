// SPDX-License-Identifier: Apache-2.0
//
// A second translation unit with all headers: nothing may be defined twice.

#include "all_headers.h"

#include "app.h"

RtFloat3 drawInSecondUnit(unsigned patternid, unsigned sampleid) {
    RixRNG::SampleCtx context{patternid, sampleid};
    return RixRNG(&context, 1).DrawSample3D(0);
}
