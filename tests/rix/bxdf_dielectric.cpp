// SPDX-License-Identifier: Apache-2.0
//
// Rough glass in the style of published Bxdfs: reflection and refraction, chosen by the Fresnel
// reflection of the microfacet. Walter et al. 2007, as in ggx.h.

#include "RixRNG.h"
#include "RixShadingUtils.h"
#include "bxdf_checks.h"
#include "ggx.h"

namespace {

const RtFloat k_minfacing = .0001f;

RtFloat s_alpha = .3f; // the checks look at several

class Glass : public RixBsdf {
public:
    Glass(RixShadingContext const* sc, RtFloat alpha, RtFloat ior)
        : RixBsdf(sc), m_alpha(alpha), m_ior(ior) {}

    void GenerateSample(RixRNG* rng, RtVector3* Ln, RtColorRGB* W, RtFloat* FPdf,
                        RtFloat* RPdf) override {
        RtInt nPts = shadingCtx->numPts;
        RtFloat2* xi = (RtFloat2*)RixAlloca(sizeof(RtFloat2) * nPts);
        rng->DrawSamples2D(nPts, xi);
        RtFloat* lobe = (RtFloat*)RixAlloca(sizeof(RtFloat) * nPts);
        rng->DrawSamples1D(nPts, lobe);

        for (int i = 0; i < nPts; i++) {
            Frame frame(shadingCtx, i, m_ior);
            RtVector3 m = GgxSampleNormal(xi[i], m_alpha);
            RtFloat F, VdM = Dot(frame.V, m);
            RixFresnelDielectric(VdM, frame.eta, &F);
            bool reflect = lobe[i] < F;
            RtVector3 L = reflect ? RixReflect(frame.V, m) : Refract(frame.V, m, frame.eta);
            Ln[i] = RixChangeBasisFrom(L, frame.X, frame.Y, frame.N);
            if (VdM > 0.f && reflect == (L.z > 0.f)) {
                Evaluate(frame, L, W[i], FPdf[i], RPdf[i]);
            } else { // the microfacet shows its back, or the light comes from the wrong side
                W[i] = RixConstants::k_ZeroRGB;
                FPdf[i] = RPdf[i] = 0.f;
            }
        }
    }

    void EvaluateSample(RixRNG* rng, RtVector3 const* Ln, RtColorRGB* W, RtFloat* FPdf,
                        RtFloat* RPdf) override {
        PIXAR_ARGUSED(rng);
        for (int i = 0; i < shadingCtx->numPts; i++) {
            Frame frame(shadingCtx, i, m_ior);
            RtVector3 L = RixChangeBasisTo(Ln[i], frame.X, frame.Y, frame.N);
            Evaluate(frame, L, W[i], FPdf[i], RPdf[i]);
        }
    }

private:
    /// The frame of a point on the side of the viewer, and the viewer in it.
    struct Frame {
        RtVector3 X, Y, V;
        RtNormal3 N;
        RtFloat eta; ///< the refractive index on the side of the viewer over the other

        Frame(RixShadingContext const* sc, int i, RtFloat ior) {
            N = RixGetForwardFacingNormal(sc->Vn[i], sc->Nn[i]);
            RixComputeShadingBasis(N, sc->Tn[i], X, Y);
            V = RixChangeBasisTo(sc->Vn[i], X, Y, N);
            eta = sc->Vn[i].Dot(sc->Nn[i]) > 0.f ? 1.f / ior : ior;
        }
    };

    /// Equation 40.
    static RtVector3 Refract(RtVector3 const& V, RtVector3 const& m, RtFloat eta) {
        RtFloat c = Dot(V, m);
        RtFloat cosBehind = std::sqrt(RixMax(0.f, 1.f + eta * eta * (c * c - 1.f)));
        RtVector3 L = m * (eta * c - cosBehind) - V * eta;
        L.Normalize();
        return L;
    }

    PRMAN_INLINE void Evaluate(Frame const& frame, RtVector3 const& L, RtColorRGB& W, RtFloat& FPdf,
                               RtFloat& RPdf) const {
        RtVector3 const& V = frame.V;
        W = RixConstants::k_ZeroRGB;
        FPdf = RPdf = 0.f;
        if (V.z <= k_minfacing || std::fabs(L.z) <= k_minfacing) return;

        bool reflect = L.z > 0.f;
        RtVector3 m = reflect ? V + L : -(V * frame.eta + L); // equations 13 and 16
        m.Normalize();
        if (m.z < 0.f) m *= -1.f;
        RtFloat VdM = Dot(V, m), LdM = Dot(L, m);
        if (VdM <= 0.f || (LdM > 0.f) != reflect) return;

        RtFloat D = GgxDistribution(m, m_alpha);
        RtFloat G = GgxMasking(V, m_alpha) * GgxMasking(L, m_alpha);
        RtFloat F = RixFresnelDielectric(VdM, frame.eta);
        if (reflect) { // equation 20
            W = RtColorRGB(F * D * G / (4.f * V.z));
            FPdf = F * D * m.z / (4.f * VdM);
            RPdf = F * D * m.z / (4.f * LdM);
        } else { // equation 21, times the cosine
            RtFloat root = frame.eta * VdM + LdM;
            RtFloat common = (1.f - F) * D / (root * root);
            RtFloat eta2 = frame.eta * frame.eta;
            W = RtColorRGB(common * G * VdM * AbsDot(L, m) * eta2 / V.z);
            FPdf = common * m.z * AbsDot(L, m); // the index of the viewer's side is eta
            RPdf = common * m.z * VdM * eta2;
        }
    }

    RtFloat m_alpha, m_ior;
};

const RtFloat k_ior = 1.5f;

class GlassFactory : public RixBxdfFactory {
public:
    RixBsdf* BeginScatter(RixShadingContext const* sc) override {
        return new Glass(sc, s_alpha, k_ior);
    }
    void EndScatter(RixBsdf* bsdf) override { delete bsdf; }
};

/// The power that leaves, of what arrives along `view`. Radiance through the surface is scaled by
/// the squared index, which power is not.
RtFloat power(Integral const& furnace, RtFloat cosView) {
    const RtFloat scale = cosView > 0.f ? k_ior * k_ior : 1.f / (k_ior * k_ior);
    return furnace.near.r + furnace.far.r * scale;
}

} // namespace

extern "C" PRMANEXPORT RixBxdfFactory* CreateRixBxdfFactory(const char* hint) {
    PIXAR_ARGUSED(hint);
    return new GlassFactory();
}

extern "C" PRMANEXPORT void DestroyRixBxdfFactory(RixBxdfFactory* factory) { delete factory; }

int main() {
    Plugin plugin;
    for (const RtFloat cosView : {1.f, .7f, .3f, -.7f, -1.f}) {
        const RtVector3 view = surfaceDirection(cosView);
        checkSampling(plugin.factory, view, 6e-3f);
        const RtFloat left = power(sampled(plugin.factory, view), cosView);
        CHECK(left > .75f && left < 1.f); // single scattering loses some
    }
    checkReciprocity(plugin.factory, k_ior * k_ior);

    // Almost smooth: nothing is lost, and known shares are reflected; all of the light that meets
    // the surface from inside beyond the critical angle, whose cosine is 0.745.
    s_alpha = .01f;
    for (const RtFloat cosView : {1.f, .5f, -.9f, -1.f}) {
        const Integral furnace = sampled(plugin.factory, surfaceDirection(cosView));
        const RtFloat reflected =
            RixFresnelDielectric(cosView, cosView > 0.f ? 1.f / k_ior : k_ior);
        CHECK(std::fabs(furnace.near.r - reflected) < 5e-3f);
        CHECK(std::fabs(power(furnace, cosView) - 1.f) < 5e-3f);
    }
    CHECK(std::fabs(sampled(plugin.factory, surfaceDirection(1.f)).near.r - .04f) < 1e-3f);
    const Integral inside = sampled(plugin.factory, surfaceDirection(-.6f));
    CHECK(std::fabs(inside.near.r - 1.f) < 5e-3f);
    CHECK(inside.far.r < 5e-3f);
    return exitCode();
}
