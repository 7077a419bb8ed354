// SPDX-License-Identifier: Apache-2.0
//
// Light selection: one 2D sample chooses a light and then a point on it, and the points on each
// light are stratified.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "check.h"

#include <cmath>

int main() {
    const unsigned numLights = 3;
    const float powers[numLights] = {6.f, 0.f, 2.f};
    unsigned counts[numLights] = {};
    unsigned columns[numLights][8] = {};

    RixRNG::SampleCtx context = {3, 0};
    RixRNG rng(&context, 1);
    const unsigned samples = 1024;
    for (unsigned k = 0; k < samples; k++) {
        RtFloat2 xi = rng.GenerateSample2D(0);
        float prob = 0.f;
        const unsigned light = RixChooseAndRemap(xi.x, powers, numLights, &prob);
        CHECK(light < numLights && xi.x >= 0.f && xi.x < 1.f);
        CHECK(prob == powers[light] / 8.f);
        counts[light]++;
        columns[light][static_cast<unsigned>(xi.x * 8.f)]++;
    }
    CHECK(counts[0] == 768 && counts[1] == 0 && counts[2] == 256);
    for (unsigned c = 0; c < 8; c++) CHECK(columns[0][c] == 96 && columns[2][c] == 32);
    return exitCode();
}
