// SPDX-License-Identifier: Apache-2.0
//
// Points on a disk by hand, with the square root, against the maps of the library.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "check.h"

#include <cmath>

int main() {
    const float radius = 2.5f;
    const unsigned count = 1024;
    unsigned insideHalfArea = 0;
    float sumX = 0.0f, sumY = 0.0f;
    RixRNG::SampleCtx context = {42, 0};
    RixRNG lens(&context, 1);
    RixRNG* rng = &lens;
    for (unsigned k = 0; k < count; k++) {
        RtFloat2 sample = rng->GenerateSample2D(0);
        RtFloat2 point;
        float r = radius * std::sqrt(sample.x);
        float angle = F_TWOPI * sample.y;
        point.x = r * std::cos(angle);
        point.y = r * std::sin(angle);

        const RtFloat2 unit = wellstrat::squareToDiskPolar(sample);
        CHECK(std::fabs(point.x - radius * unit.x) < 1e-5f);
        CHECK(std::fabs(point.y - radius * unit.y) < 1e-5f);
        CHECK(point.x * point.x + point.y * point.y < radius * radius * 1.000001f);
        if (point.x * point.x + point.y * point.y < 0.5f * radius * radius) ++insideHalfArea;
        sumX += point.x;
        sumY += point.y;
    }
    // sample.x is stratified in 1024 parts, so exactly half of the points are in half of the area.
    CHECK(insideHalfArea == count / 2);
    CHECK(std::fabs(sumX) / count < 0.01f && std::fabs(sumY) / count < 0.01f);
    return exitCode();
}
