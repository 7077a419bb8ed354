// SPDX-License-Identifier: Apache-2.0
//
// The rough surface of these programs: GGX, by Walter et al. 2007, "Microfacet Models for
// Refraction through Rough Surfaces", EGSR, sections 5.2 and 5.4. Directions are in a frame whose z
// is the normal; alpha is the roughness, above 0.

#pragma once

#include "RixShadingUtils.h"

/// The density of microfacet normals, of either side: equation 33.
inline RtFloat GgxDistribution(RtVector3 const& m, RtFloat alpha) {
    RtFloat cos2 = m.z * m.z;
    RtFloat a2 = alpha * alpha;
    RtFloat e = RixMix(1.f, a2, cos2); // cos^2 (a^2 + tan^2), without its poles
    return a2 * F_INVPI / (e * e);
}

/// The share of microfacets that are not hidden from `v`: equation 34.
inline RtFloat GgxMasking(RtVector3 const& v, RtFloat alpha) {
    RtFloat cos2 = RixMax(v.z * v.z, 1e-12f);
    RtFloat tan2 = RixMax(0.f, 1.f - cos2) / cos2;
    return 2.f / (1.f + std::sqrt(1.f + alpha * alpha * tan2));
}

/// A microfacet normal of density GgxDistribution(m) * m.z: equations 35 and 36.
inline RtVector3 GgxSampleNormal(RtFloat2 const& xi, RtFloat alpha) {
    RtFloat tan2 = alpha * alpha * xi.x / (1.f - xi.x);
    RtFloat cosTheta = 1.f / std::sqrt(1.f + tan2);
    RtFloat sinTheta = std::sqrt(tan2) * cosTheta;
    return RixSphericalDirection(sinTheta, cosTheta, F_TWOPI * xi.y);
}
