// SPDX-License-Identifier: Apache-2.0
//
// The few types that a renderer supplies to a Bxdf, as far as these programs need them: the points
// of a batch, the interface of a Bxdf, and that of its factory. They stand in for RenderMan's.

#pragma once

#include "RixRNG.h"

/// A batch of points. The vectors have length 1 and point away from the surface; the tangent need
/// not be at right angles to the normal. Not owned.
struct RixShadingContext {
    RtInt numPts;
    RtVector3 const* Vn; ///< to the viewer
    RtNormal3 const* Nn; ///< of the outside
    RtVector3 const* Tn;
};

/// Directions to the light, one for each point, with the weight (what arrives from there at the
/// viewer, times the cosine) and the probability density of choosing it, forward (given Vn) and
/// reverse (Vn, given Ln). Where there is nothing to choose, both densities are 0.
class RixBsdf {
public:
    explicit RixBsdf(RixShadingContext const* sc) : shadingCtx(sc) {}
    virtual ~RixBsdf() = default;
    RixBsdf(RixBsdf const&) = delete;
    RixBsdf& operator=(RixBsdf const&) = delete;

    virtual void GenerateSample(RixRNG* rng, RtVector3* Ln, RtColorRGB* W, RtFloat* FPdf,
                                RtFloat* RPdf) = 0;
    virtual void EvaluateSample(RixRNG* rng, RtVector3 const* Ln, RtColorRGB* W, RtFloat* FPdf,
                                RtFloat* RPdf) = 0;

protected:
    RixShadingContext const* shadingCtx;
};

class RixBxdfFactory {
public:
    virtual ~RixBxdfFactory() = default;
    virtual RixBsdf* BeginScatter(RixShadingContext const* sc) = 0;
    virtual void EndScatter(RixBsdf* bsdf) = 0;
};
