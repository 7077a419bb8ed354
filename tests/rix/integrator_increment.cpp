// SPDX-License-Identifier: Apache-2.0
//
// An integrator that takes several samples at each point: it steps the contexts itself, because
// whom it calls only draws.

#include "RixRNG.h"
#include "check.h"

#include <set>
#include <utility>
#include <vector>

int main() {
    const int numPts = 5;
    std::vector<RixRNG::SampleCtx> sampleCtxArray;
    for (unsigned i = 0; i < numPts; i++) sampleCtxArray.push_back({i * 977u, 0});
    RixRNG rng(sampleCtxArray.data(), numPts);

    // Of 256 samples, each of the 16 x 16 cells of the square gets one.
    std::vector<std::set<std::pair<int, int>>> cells(numPts);
    std::vector<RtFloat2> xi(numPts), repeated(numPts);
    for (int bounceSample = 0; bounceSample < 256; bounceSample++) {
        rng.DrawSamples2D(xi.data());
        rng.DrawSamples2D(repeated.data());
        CHECK(xi == repeated);
        for (int i = 0; i < numPts; i++) {
            cells[i].emplace(static_cast<int>(xi[i].x * 16), static_cast<int>(xi[i].y * 16));
        }
        for (int i = 0; i < numPts; i++) sampleCtxArray[i].sampleid++;
    }

    for (int i = 0; i < numPts; i++) {
        CHECK(cells[i].size() == 256);
        CHECK(sampleCtxArray[i].sampleid == 256);
    }
    return exitCode();
}
