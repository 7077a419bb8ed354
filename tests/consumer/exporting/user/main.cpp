// SPDX-License-Identifier: Apache-2.0

#include "sampler.h"

int main() {
    RixRNG::SampleCtx context{7, 3};
    return RixRNG(&context, 1).DrawSample2D(0) == sampleOf(7, 3) ? 0 : 1;
}
