// SPDX-License-Identifier: Apache-2.0
//
// How surfaces scatter light: the metallic-roughness material of glTF 2.0 as the sum of a diffuse
// and a specular lobe, and one of light that passes through. The specular lobe is GGX with the
// height-correlated shadowing of Smith (Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces"; Heitz 2014, "Understanding the Masking-Shadowing Function in
// Microfacet-Based BRDFs", JCGT 3(2)) and the Fresnel factor F of Schlick. The diffuse lobe gets
// what F leaves on the way in and on the way out:
//
//     baseColor / pi (1 - F(in)) (1 - F(out)) / (1 - mean of F over the hemisphere by the cosine)
//
// which is reciprocal, and makes the two lobes together reflect all light off a smooth white
// surface (Shirley et al. 1997, "A Practitioners' Assessment of Light Reflection Models", Pacific
// Graphics). GGX scatters light once, so rough metals are too dark by what would scatter again.
//
// Where light passes, F is that of Fresnel's equations, and what it leaves passes the microfacets
// of the same GGX: refracted into and out of solid bodies, straight on through thin sheets, as the
// mirror image of what is reflected (glTF's KHR_materials_transmission and _volume). Radiance
// stands for radiance over the squared index of refraction where the light is (basic radiance),
// which refraction does not change: nothing is lost or won on the way through a body.

#pragma once

#include "bxdf_parameters.h"

#include "wellstrat/vector.h"

namespace wellstrat::render {

/// What a direction is worth.
struct BxdfValue {
    Float3 value; ///< of the bxdf times the cosine to the shading normal
    float pdf;    ///< per unit solid angle
};

/// A direction that was chosen.
struct BxdfSample {
    Float3 direction;
    Float3 weight; ///< value / pdf
    float pdf;
};

/// Scattering at one point, seen from one direction. Nothing here is NaN or infinite for finite
/// material parameters; colors and parameters count as clamped to [0, 1].
class Bxdf {
public:
    Bxdf() = default;

    /// At a point with this geometric and shading normal; `view` has unit length and points away
    /// from the surface, to either side.
    Bxdf(const BxdfParameters& parameters, Float3 geometricNormal, Float3 shadingNormal,
         Float3 view);

    /// For a unit vector that points to where light comes from. Where no light passes, directions
    /// below the shading normal have value and pdf 0. Those that are on different sides of the two
    /// normals have value 0.
    BxdfValue evaluate(Float3 direction) const;

    /// Chooses a lobe with xi.x, by its share of the scattered light, and with all of xi a
    /// direction of the lobe. Returns false if no light can come that way.
    bool sample(Float2 xi, BxdfSample& sample) const;

    /// Is light from there light that passes through the surface?
    bool passes(Float3 direction) const { return letsPass() && isBehind(direction); }

private:
    Float3 toLocal(Float3 v) const {
        return {Dot(v, tangent_), Dot(v, bitangent_), Dot(v, normal_)};
    }
    Float3 toWorld(Float3 v) const { return tangent_ * v.x + bitangent_ * v.y + normal_ * v.z; }
    BxdfValue evaluateLocal(Float3 in) const;
    BxdfValue evaluatePassing(Float3 in) const;
    BxdfValue passingBy(Float3 half, Float3 in) const;
    bool samplePassing(Float2 xi, Float3& in, BxdfValue& value) const;
    bool letsPass() const { return eta_ > 0.0f; }
    bool isBehind(Float3 direction) const { return !(Dot(direction, geometricNormal_) > 0.0f); }
    float dielectricReflection(float cosine) const;
    Float3 reflection(float cosine) const;
    float passingDielectric(float cosine) const;
    Float3 passingReflection(float cosine) const;
    float shadowing(float inCosine, Float3 in) const;

    Float3 tangent_, bitangent_, normal_; ///< the shading frame, on the side of the view
    Float3 geometricNormal_;              ///< on the side of the view
    Float3 view_;                         ///< in the shading frame
    Float3 diffuse_; ///< all factors of the diffuse lobe that do not depend on the way in
    float dielectricF0_;
    Float3 f0_;
    float alpha_;
    float specularProbability_;

    // Of what lets light pass:
    float eta_ = 0; ///< the index of refraction on the side of the view over the other; 0: none is
    float passingProbability_ = 0;
    float metallic_;
    bool isSolid_;
    Float3 passingColor_;
};

} // namespace wellstrat::render
