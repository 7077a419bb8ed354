// SPDX-License-Identifier: Apache-2.0
//
// A thin diffuse sheet in the style of published Bxdfs: light of one color is reflected, and of
// another let through, both by the cosine.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "bxdf_checks.h"

namespace {

const RtFloat k_minfacing = .0001f; // edges of the surface are black

class DiffuseSheet : public RixBsdf {
public:
    DiffuseSheet(RixShadingContext const* sc, RtColorRGB const& reflected,
                 RtColorRGB const& through)
        : RixBsdf(sc), m_reflected(reflected), m_through(through),
          m_reflectProb(reflected.ChannelAvg() / (reflected + through).ChannelAvg()) {}

    void GenerateSample(RixRNG* rng, RtVector3* Ln, RtColorRGB* W, RtFloat* FPdf,
                        RtFloat* RPdf) override {
        RtInt nPts = shadingCtx->numPts;
        RtFloat2* xi = (RtFloat2*)RixAlloca(sizeof(RtFloat2) * nPts);
        rng->DrawSamples2D(nPts, xi);

        for (int i = 0; i < nPts; i++) {
            // One sample chooses the side and then the direction.
            RtNormal3 N = RixChooseAndRemap(xi[i].x, m_reflectProb) == 0
                              ? RixGetForwardFacingNormal(shadingCtx->Vn[i], shadingCtx->Nn[i])
                              : RixGetBackwardFacingNormal(shadingCtx->Vn[i], shadingCtx->Nn[i]);
            RtFloat cosTheta;
            RixCosDirectionalDistribution(xi[i], N, Ln[i], cosTheta);
            Evaluate(i, Ln[i], W[i], FPdf[i], RPdf[i]);
        }
    }

    void EvaluateSample(RixRNG* rng, RtVector3 const* Ln, RtColorRGB* W, RtFloat* FPdf,
                        RtFloat* RPdf) override {
        PIXAR_ARGUSED(rng);
        for (int i = 0; i < shadingCtx->numPts; i++) Evaluate(i, Ln[i], W[i], FPdf[i], RPdf[i]);
    }

private:
    PRMAN_INLINE void Evaluate(int i, RtVector3 const& L, RtColorRGB& W, RtFloat& FPdf,
                               RtFloat& RPdf) const {
        RtFloat NdV;
        RtNormal3 Nf = RixGetForwardFacingNormal(shadingCtx->Vn[i], shadingCtx->Nn[i], &NdV);
        W = RixConstants::k_ZeroRGB;
        FPdf = RPdf = 0.f;
        if (NdV <= k_minfacing) return;
        bool reflect = Nf.Dot(L) > 0.f;
        RtFloat prob = reflect ? m_reflectProb : 1.f - m_reflectProb;
        W = (reflect ? m_reflected : m_through) * (Nf.AbsDot(L) * F_INVPI);
        FPdf = prob * Nf.AbsDot(L) * F_INVPI;
        RPdf = prob * NdV * F_INVPI;
    }

    RtColorRGB m_reflected, m_through;
    RtFloat m_reflectProb;
};

const RtColorRGB k_reflected(.5f, .3f, .1f), k_through(.1f, .2f, .3f);

class DiffuseSheetFactory : public RixBxdfFactory {
public:
    RixBsdf* BeginScatter(RixShadingContext const* sc) override {
        assert(sc->numPts > 0); // <cassert> comes with the headers
        return new DiffuseSheet(sc, k_reflected, k_through);
    }
    void EndScatter(RixBsdf* bsdf) override { delete bsdf; }
};

} // namespace

extern "C" PRMANEXPORT RixBxdfFactory* CreateRixBxdfFactory(const char* hint) {
    PIXAR_ARGUSED(hint);
    return new DiffuseSheetFactory();
}

extern "C" PRMANEXPORT void DestroyRixBxdfFactory(RixBxdfFactory* factory) { delete factory; }

int main() {
    Plugin plugin;
    for (const RtFloat cosView : {1.f, .6f, .1f, -.1f, -.6f, -1.f}) {
        const RtVector3 view = surfaceDirection(cosView);
        // Each sample weighs the same, so this is exact but for how many go to either side.
        const Integral furnace = sampled(plugin.factory, view);
        CHECK(closeTo(furnace.near, k_reflected, 1e-3f));
        CHECK(closeTo(furnace.far, k_through, 1e-3f));
        CHECK(std::fabs(furnace.density - 1.f) < 1e-5f);
        checkSampling(plugin.factory, view, 1e-3f);
    }
    checkReciprocity(plugin.factory);
    return exitCode();
}
