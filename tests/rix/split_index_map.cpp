// SPDX-License-Identifier: Apache-2.0
//
// A new RixRNG for points that are fewer than the parent's and in another order: each context is
// made by itself, through the map from shading points to those of the integrator.

#include "RixRNG.h"
#include "check.h"

#include <algorithm>
#include <vector>

namespace {

/// What an integrator knows of the points that hit one surface.
struct ShadingContext {
    int numPts;
    const int* integratorCtxIndex;
};

} // namespace

int main() {
    const unsigned splits = 4;
    std::vector<RixRNG::SampleCtx> integratorContexts;
    for (unsigned i = 0; i < 8; i++) integratorContexts.push_back({500, i});
    RixRNG integratorRng(integratorContexts.data(), 8);
    const RixRNG* parent = &integratorRng;

    const int order[] = {6, 1, 3, 0, 7};
    const ShadingContext surface = {5, order};
    const ShadingContext* shadingContext = &surface;
    const int numPts = shadingContext->numPts;

    RixRNG::SampleCtx* samplectxarray = new RixRNG::SampleCtx[numPts];
    RixRNG rng(parent, samplectxarray, numPts);
    RixRNG::Scramble scramble = static_cast<RixRNG::Scramble>(0x51c64e6d);
    for (int pt = 0; pt < numPts; pt++) {
        int index = shadingContext->integratorCtxIndex[pt];
        samplectxarray[pt] = parent->NewDomainSplit(index, scramble, splits);
    }

    // All eight points belong to one pixel, so together they take 32 consecutive samples of one new
    // domain, of which these five take 20 different ones.
    std::vector<unsigned> taken;
    for (int pt = 0; pt < numPts; pt++) {
        CHECK(samplectxarray[pt].patternid == parent->NewDomain(0, scramble).patternid);
        CHECK(samplectxarray[pt].sampleid == splits * static_cast<unsigned>(order[pt]));
    }
    std::vector<RtFloat2> xi(numPts);
    for (unsigned split = 0; split < splits; split++) {
        for (int pt = 0; pt < numPts; pt++) taken.push_back(samplectxarray[pt].sampleid);
        rng.GenerateSamples2D(xi.data());
    }
    std::sort(taken.begin(), taken.end());
    CHECK(std::adjacent_find(taken.begin(), taken.end()) == taken.end());
    CHECK(taken.front() == 0 && taken.back() == 31);

    delete[] samplectxarray;
    return exitCode();
}
