// SPDX-License-Identifier: Apache-2.0
//
// A Bxdf that needs one 2D sample for each point of the batch, in memory of RixAlloca.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "check.h"

#include <cmath>
#include <vector>

namespace {

class DiffuseBxdf {
public:
    DiffuseBxdf(const RtNormal3* normals, RtInt count) : Nn(normals), numPts(count) {}

    void GenerateSample(RixRNG* rng, RtVector3* Ln, RtFloat* FPdf) const {
        RtFloat2* xi = static_cast<RtFloat2*>(RixAlloca(sizeof(RtFloat2) * numPts));
        rng->DrawSamples2D(xi);
        for (RtInt i = 0; i < numPts; i++) {
            RtFloat cosTheta;
            RixCosDirectionalDistribution(xi[i], Nn[i], Ln[i], cosTheta);
            FPdf[i] = cosTheta * F_INVPI;
        }
    }

private:
    const RtNormal3* Nn;
    RtInt numPts;
};

} // namespace

int main() {
    const unsigned numPts = 64;
    std::vector<RixRNG::SampleCtx> contexts;
    for (unsigned i = 0; i < numPts; i++) contexts.push_back({1000 + 7 * i, i});
    RixRNG rng(contexts.data(), numPts);

    const std::vector<RtNormal3> normals(numPts, RtNormal3(0.6f, 0.0f, 0.8f));
    std::vector<RtVector3> directions(numPts), again(numPts);
    std::vector<RtFloat> pdfs(numPts);
    const DiffuseBxdf bxdf(normals.data(), numPts);
    bxdf.GenerateSample(&rng, directions.data(), pdfs.data());

    for (unsigned i = 0; i < numPts; i++) {
        const RtFloat cosine = directions[i].Dot(normals[i]);
        CHECK(cosine > 0.0f);
        CHECK(std::fabs(pdfs[i] - cosine * F_INVPI) < 1e-6f);
        CHECK(contexts[i].patternid == 1000 + 7 * i && contexts[i].sampleid == i);
    }

    // Drawing has left the contexts as they were, so the Bxdf does the same again.
    bxdf.GenerateSample(&rng, again.data(), pdfs.data());
    CHECK(again == directions);
    return exitCode();
}
