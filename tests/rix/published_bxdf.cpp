// SPDX-License-Identifier: Apache-2.0
//
// A Bxdf of two lobes in the style of published ones: directions from 2D samples and the lobe from
// 1D samples of the same RixRNG, counts first. In a white furnace it must return its own albedo.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "check.h"

#include <cmath>
#include <set>
#include <vector>

namespace {

const RtFloat k_minfacing = .0001f;

/// A cosine lobe of one color, and an even glow over the hemisphere of another.
class TwoLobeBxdf {
public:
    TwoLobeBxdf(RtInt count, const RtVector3* view, const RtNormal3* normal)
        : nPts(count), m_Vn(view), m_Nn(normal), m_DiffuseColor(0.5f, 0.2f, 0.f),
          m_GlowColor(0.1f, 0.3f, 0.2f) {}

    void GenerateSample(RixRNG* rng, RtVector3* Ln, RtColorRGB* W, RtFloat* FPdf) const {
        RtFloat2* xi = (RtFloat2*)RixAlloca(sizeof(RtFloat2) * nPts);
        rng->DrawSamples2D(nPts, xi);
        RtFloat* lobe = (RtFloat*)RixAlloca(sizeof(RtFloat) * nPts);
        rng->DrawSamples1D(nPts, lobe);

        for (int i = 0; i < nPts; i++) {
            RtFloat NdV;
            RtNormal3 Nf = RixGetForwardFacingNormal(m_Vn[i], m_Nn[i], &NdV);
            FPdf[i] = 0.f;
            if (NdV <= k_minfacing) continue;

            RtFloat cosTheta = 0.f;
            if (lobe[i] > .5f || m_DiffuseColor.IsBlack()) {
                RixUniformDirectionalDistribution(xi[i], Nf, Ln[i], cosTheta);
            } else {
                RixCosDirectionalDistribution(xi[i], Nf, Ln[i], cosTheta);
            }
            EvaluateSample(Nf.Dot(Ln[i]), W[i], FPdf[i]);
        }
    }

    RtColorRGB Albedo() const { return m_DiffuseColor + m_GlowColor; }

private:
    PRMAN_INLINE void EvaluateSample(RtFloat NdL, RtColorRGB& W, RtFloat& FPdf) const {
        FPdf = .5f * (NdL * F_INVPI + F_INVTWOPI);
        W = m_DiffuseColor * (NdL * F_INVPI) + m_GlowColor * F_INVTWOPI;
    }

    RtInt nPts;
    const RtVector3* m_Vn;
    const RtNormal3* m_Nn;
    RtColorRGB m_DiffuseColor, m_GlowColor;
};

RtFloat largestChannel(RtColorRGB color) { return RixMax(color.ChannelMax(), -color.ChannelMin()); }

} // namespace

int main() {
    const RtInt nPts = 1024;
    std::vector<RixRNG::SampleCtx> contexts;
    for (unsigned i = 0; i < nPts; i++) contexts.push_back({77, i});
    RixRNG rng(contexts.data(), nPts);

    // Half of the normals face away from the viewer.
    std::vector<RtVector3> view(nPts, RtVector3(0.f, 0.6f, 0.8f)), directions(nPts);
    std::vector<RtNormal3> normals;
    for (int i = 0; i < nPts; i++) normals.push_back(RtNormal3(0.f, 0.f, i % 2 ? 1.f : -1.f));
    std::vector<RtColorRGB> weights(nPts);
    std::vector<RtFloat> pdfs(nPts);
    const TwoLobeBxdf bxdf(nPts, view.data(), normals.data());
    bxdf.GenerateSample(&rng, directions.data(), weights.data(), pdfs.data());

    RtColorRGB furnace(0.f);
    for (int i = 0; i < nPts; i++) {
        CHECK(pdfs[i] > 0.f);
        CHECK(directions[i].z > 0.f);
        furnace += weights[i] / pdfs[i];
    }
    furnace /= static_cast<RtFloat>(nPts);
    CHECK(largestChannel(furnace - bxdf.Albedo()) < 0.002f);

    // The lobe and the direction together are one 3D sample: 64 of them fill the 4 x 4 x 4 cells.
    std::vector<RtFloat2> xi(nPts);
    std::vector<RtFloat> lobe(nPts);
    rng.DrawSamples2D(nPts, xi.data());
    rng.DrawSamples1D(nPts, lobe.data());
    for (int first = 0; first < nPts; first += 64) {
        std::set<int> cells;
        for (int i = first; i < first + 64; i++) {
            cells.insert(static_cast<int>(xi[i].x * 4) + 4 * static_cast<int>(xi[i].y * 4) +
                         16 * static_cast<int>(lobe[i] * 4));
        }
        CHECK(cells.size() == 64);
    }
    return exitCode();
}
