// SPDX-License-Identifier: Apache-2.0
//
// A rough metal in the style of published Bxdfs, with the Fresnel reflection of gold.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "bxdf_checks.h"
#include "ggx.h"

namespace {

const RtFloat k_minfacing = .0001f;

RtFloat s_alpha = .3f; // the checks look at several

class Metal : public RixBsdf {
public:
    Metal(RixShadingContext const* sc, RtFloat alpha, RtColorRGB const& eta,
          RtColorRGB const& kappa)
        : RixBsdf(sc), m_alpha(alpha), m_eta(eta), m_kappa(kappa) {}

    void GenerateSample(RixRNG* rng, RtVector3* Ln, RtColorRGB* W, RtFloat* FPdf,
                        RtFloat* RPdf) override {
        RtInt nPts = shadingCtx->numPts;
        RtFloat2* xi = (RtFloat2*)RixAlloca(sizeof(RtFloat2) * nPts);
        rng->DrawSamples2D(nPts, xi);

        for (int i = 0; i < nPts; i++) {
            RtVector3 const& V = shadingCtx->Vn[i];
            RtVector3 TX, TY;
            RixComputeShadingBasis(shadingCtx->Nn[i], shadingCtx->Tn[i], TX, TY);
            RtVector3 Wh =
                RixChangeBasisFrom(GgxSampleNormal(xi[i], m_alpha), TX, TY, shadingCtx->Nn[i]);
            Ln[i] = RixReflect(V, Wh);
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
        RtVector3 TX, TY;
        RixComputeShadingBasis(shadingCtx->Nn[i], shadingCtx->Tn[i], TX, TY);
        RtVector3 Vl = RixChangeBasisTo(shadingCtx->Vn[i], TX, TY, shadingCtx->Nn[i]);
        RtVector3 Ll = RixChangeBasisTo(L, TX, TY, shadingCtx->Nn[i]);
        W = RtColorRGB(0.f);
        FPdf = RPdf = 0.f;
        if (Vl.z <= k_minfacing || Ll.z <= 0.f) return;

        RtVector3 Wh = Vl + Ll;
        Wh.Normalize();
        RtFloat D = GgxDistribution(Wh, m_alpha);
        RtFloat G = GgxMasking(Vl, m_alpha) * GgxMasking(Ll, m_alpha);
        RtColorRGB F;
        RixFresnelConductor(Dot(Wh, Ll), m_eta, m_kappa, &F);

        W = F * (D * G / (4.f * Vl.z));
        FPdf = D * Wh.z / (4.f * AbsDot(Vl, Wh));
        RPdf = D * Wh.z / (4.f * AbsDot(Ll, Wh));
    }

    RtFloat m_alpha;
    RtColorRGB m_eta, m_kappa;
};

// Roughly those of gold.
const RtColorRGB k_eta(.2f, .5f, 1.3f), k_kappa(3.4f, 2.2f, 1.9f);

class MetalFactory : public RixBxdfFactory {
public:
    RixBsdf* BeginScatter(RixShadingContext const* sc) override {
        return new Metal(sc, s_alpha, k_eta, k_kappa);
    }
    void EndScatter(RixBsdf* bsdf) override { delete bsdf; }
};

} // namespace

extern "C" PRMANEXPORT RixBxdfFactory* CreateRixBxdfFactory(const char* hint) {
    PIXAR_ARGUSED(hint);
    return new MetalFactory();
}

extern "C" PRMANEXPORT void DestroyRixBxdfFactory(RixBxdfFactory* factory) { delete factory; }

int main() {
    Plugin plugin;
    for (const RtFloat cosView : {1.f, .7f, .3f}) {
        const RtVector3 view = surfaceDirection(cosView);
        checkSampling(plugin.factory, view, 5e-3f);
        CHECK(sampled(plugin.factory, view).near.ChannelMax() < 1.f);
    }
    CHECK(sampled(plugin.factory, surfaceDirection(-.5f)).density == 0.f); // the back is black
    checkReciprocity(plugin.factory);

    // Almost a mirror: seen at right angles what the formula for these says, and then Fresnel's.
    s_alpha = .01f;
    const RtColorRGB one(1.f);
    const RtColorRGB k2 = k_kappa * k_kappa;
    const RtColorRGB expected =
        ((k_eta - one) * (k_eta - one) + k2) / ((k_eta + one) * (k_eta + one) + k2);
    CHECK(closeTo(sampled(plugin.factory, surfaceDirection(1.f)).near, expected, 2e-3f));
    CHECK(closeTo(sampled(plugin.factory, surfaceDirection(.5f)).near,
                  RixFresnelConductor(.5f, k_eta, k_kappa), 5e-3f));
    return exitCode();
}
