// SPDX-License-Identifier: Apache-2.0
//
// Cloth in the style of published Bxdfs: a sheen of fibers that stand up, over a diffuse ground.
// Estevez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF", with the visibility of
// Neubelt and Pettineo 2013, "Crafting a Next-Gen Material Pipeline for The Order: 1886", and
// uniform directions, as sheen wants them.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "bxdf_checks.h"

namespace {

const RtFloat k_minfacing = .0001f;

/// The density of fiber normals at this angle: a power of the sine.
PRMAN_INLINE RtFloat SheenDistribution(RtFloat cosTheta, RtFloat roughness) {
    RtFloat sin2 = RixClamp(1.f - cosTheta * cosTheta, 0.f, 1.f);
    RtFloat power = 1.f / roughness;
    return (2.f + power) * std::pow(sin2, .5f * power) * F_INVTWOPI;
}

class Cloth : public RixBsdf {
public:
    Cloth(RixShadingContext const* sc, RtColorRGB const& ground, RtColorRGB const& sheen,
          RtFloat roughness, RtFloat mix)
        : RixBsdf(sc), m_ground(ground), m_sheen(sheen), m_roughness(roughness), m_mix(mix) {}

    void GenerateSample(RixRNG* rng, RtVector3* Ln, RtColorRGB* W, RtFloat* FPdf,
                        RtFloat* RPdf) override {
        RtInt nPts = shadingCtx->numPts;
        RtFloat2* xi = static_cast<RtFloat2*>(RixAlloca(sizeof(RtFloat2) * nPts));
        rng->DrawSamples2D(xi);

        for (int i = 0; i < nPts; i++) {
            RtNormal3 Nf = RixGetForwardFacingNormal(shadingCtx->Vn[i], shadingCtx->Nn[i]);
            RtVector3 wt, wb;
            Nf.CreateOrthonormalBasis(wt, wb);
            float cosTheta;
            RixUniformDirectionalDistribution(xi[i], Nf, wt, wb, Ln[i], cosTheta);
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
        RtVector3 const& V = shadingCtx->Vn[i];
        RtNormal3 Nf = RixGetForwardFacingNormal(V, shadingCtx->Nn[i], &NdV);
        RtFloat NdL = Nf.Dot(L);
        W = RtColorRGB(0.f);
        FPdf = RPdf = 0.f;
        if (NdV <= k_minfacing || NdL <= 0.f) return;

        RtVector3 Wh = V + L;
        Wh.Normalize();
        RtFloat D = SheenDistribution(Nf.Dot(Wh), m_roughness);
        RtFloat visible = 1.f / (4.f * (NdL + NdV - NdL * NdV));
        W = RixMix(m_ground * F_INVPI, m_sheen * (D * visible), m_mix) * NdL;
        FPdf = RPdf = F_INVTWOPI;
    }

    RtColorRGB m_ground, m_sheen;
    RtFloat m_roughness, m_mix;
};

const RtColorRGB k_ground(.4f, .1f, .1f), k_sheen(.8f, .8f, 1.f);
const RtFloat k_roughness = .3f;
RtFloat s_mix = 1.f; // the checks look at several

class ClothFactory : public RixBxdfFactory {
public:
    RixBsdf* BeginScatter(RixShadingContext const* sc) override {
        return new Cloth(sc, k_ground, k_sheen, k_roughness, s_mix);
    }
    void EndScatter(RixBsdf* bsdf) override { delete bsdf; }
};

} // namespace

extern "C" PRMANEXPORT RixBxdfFactory* CreateRixBxdfFactory(const char* hint) {
    PIXAR_ARGUSED(hint);
    return new ClothFactory();
}

extern "C" PRMANEXPORT void DestroyRixBxdfFactory(RixBxdfFactory* factory) { delete factory; }

int main() {
    Plugin plugin;
    RtColorRGB last(0.f);
    for (const RtFloat cosView : {1.f, .6f, .2f}) {
        const RtVector3 view = surfaceDirection(cosView);
        s_mix = 1.f;
        checkSampling(plugin.factory, view, 5e-3f);
        const RtColorRGB sheen = sampled(plugin.factory, view).near;
        CHECK(sheen.ChannelMax() < 1.f);
        CHECK(sheen.r > last.r); // brighter towards the edge, as cloth is
        last = sheen;

        s_mix = 0.f;
        CHECK(closeTo(sampled(plugin.factory, view).near, k_ground, 2e-3f));
        s_mix = .25f;
        CHECK(closeTo(sampled(plugin.factory, view).near, RixMix(k_ground, sheen, .25f), 2e-3f));
    }
    checkReciprocity(plugin.factory);

    // The projected area of the fibers' normals is 1: the integral of D times the cosine.
    RtFloat area = 0.f;
    const int steps = 4096;
    for (int i = 0; i < steps; i++) {
        const RtFloat cosTheta = (static_cast<RtFloat>(i) + .5f) / steps;
        area += SheenDistribution(cosTheta, k_roughness) * cosTheta * F_TWOPI / steps;
    }
    CHECK(std::fabs(area - 1.f) < 1e-3f);
    return exitCode();
}
