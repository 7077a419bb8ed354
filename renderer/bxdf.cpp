// SPDX-License-Identifier: Apache-2.0
#include "bxdf.h"

#include "color.h"
#include "schlick.h"

#include <RixShadingUtils.h>

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

/// Views at a smaller cosine to the shading normal bend it towards them.
constexpr float kSmallestCosine = 0x1p-10f;

Float3 mirrored(Float3 v) { return {v.x, v.y, -v.z}; }

} // namespace

Bxdf::Bxdf(const BxdfParameters& parameters, Float3 geometricNormal, Float3 shadingNormal,
           Float3 view)
    : dielectricF0_(parameters.dielectricF0), f0_(parameters.f0), alpha_(parameters.alpha) {
    geometricNormal_ = RixGetForwardFacingNormal(view, geometricNormal);
    normal_ = RixGetForwardFacingNormal(geometricNormal_, shadingNormal);
    const float cosine = Dot(normal_, view);
    if (cosine < kSmallestCosine) {
        normal_ += view * (kSmallestCosine - cosine);
        normal_.Normalize();
    }
    normal_.CreateOrthonormalBasis(tangent_, bitangent_);
    view_ = toLocal(view);
    view_.z = std::max(view_.z, 0.5f * kSmallestCosine);

    float passingShare = 0.0f;
    if (parameters.ior > 0.0f) {
        isSolid_ = parameters.isSolid;
        metallic_ = parameters.metallic;
        passingColor_ = parameters.passingColor;
        const bool isInside = isSolid_ && Dot(view, geometricNormal) < 0.0f;
        eta_ = isInside ? parameters.ior : 1.0f / parameters.ior;
        passingShare = largestChannel(passingColor_) * (1.0f - dielectricReflection(view_.z));
    }
    const Float3 diffuseAlbedo = parameters.diffuseColor * (1.0f - dielectricReflection(view_.z));
    diffuse_ = diffuseAlbedo * parameters.diffuseScale;

    const float diffuseShare = largestChannel(diffuseAlbedo);
    float specularShare = largestChannel(reflection(view_.z));
    if (letsPass()) { // The rougher, the more microfacets reflect another part than most.
        const float mean = 0.5f * (specularShare + passingShare);
        const float roughness = std::sqrt(alpha_);
        specularShare += (mean - specularShare) * roughness;
        passingShare += (mean - passingShare) * roughness;
    }
    const float all = diffuseShare + specularShare + passingShare;
    specularProbability_ = all > 0.0f ? specularShare / all : 0.0f;
    passingProbability_ = all > 0.0f ? passingShare / all : 0.0f;
}

inline float Bxdf::dielectricReflection(float cosine) const {
    return letsPass() ? passingDielectric(cosine) : Schlick{dielectricF0_}.at(cosine);
}

inline Float3 Bxdf::reflection(float cosine) const {
    return letsPass() ? passingReflection(cosine) : schlick(f0_, cosine);
}

// Where light passes; functions of their own, for that is rare.
float Bxdf::passingDielectric(float cosine) const { return fresnelDielectric(cosine, eta_); }

Float3 Bxdf::passingReflection(float cosine) const {
    return lerp(Float3(passingDielectric(cosine)), schlick(f0_, cosine), metallic_);
}

/// The visible normals have the masking of the view in them; what is left is the ratio of the
/// masking and shadowing of both to it, Heitz 2014, equations 43 and 99.
float Bxdf::shadowing(float inCosine, Float3 in) const {
    const auto scaled = [this](Float3 v) {
        return Float3(alpha_ * v.x, alpha_ * v.y, v.z).Length();
    };
    const float viewLength = scaled(view_);
    return inCosine * (view_.z + viewLength) / (inCosine * viewLength + view_.z * scaled(in));
}

BxdfValue Bxdf::evaluateLocal(Float3 in) const {
    BxdfValue result{Float3(0.0f), 0.0f};
    if (!(in.z > 0.0f)) return letsPass() ? evaluatePassing(in) : result;
    const float diffuseProbability = 1.0f - specularProbability_ - passingProbability_;
    if (diffuseProbability > 0.0f) {
        result.value = diffuse_ * (in.z * (1.0f - dielectricReflection(in.z)));
        result.pdf = diffuseProbability * hemisphereCosinePdf(in.z);
    }
    if (specularProbability_ > 0.0f) {
        Float3 half = in + view_;
        half.Normalize();
        const float cosine = std::max(Dot(view_, half), kSmallestCosine);
        const float normalPdf = ggxVisibleNormalPdf(half, view_, alpha_, alpha_);
        const float pdf = normalPdf / (4.0f * cosine);
        result.value += reflection(cosine) * (pdf * shadowing(in.z, in));
        result.pdf += specularProbability_ * pdf;
    }
    return result;
}

/// Of a direction on the other side.
BxdfValue Bxdf::evaluatePassing(Float3 in) const {
    if (!(in.z < 0.0f)) return {Float3(0.0f), 0.0f};
    Float3 half = isSolid_ ? view_ * eta_ + in : view_ + mirrored(in); // Walter 2007, equation 16
    half.Normalize();
    return passingBy(half.z < 0.0f ? -half : half, in);
}

/// Of a direction on the other side, to which `half` refracts the view, or reflects it before it is
/// mirrored.
BxdfValue Bxdf::passingBy(Float3 half, Float3 in) const {
    const float cosine = Dot(view_, half);
    float density = 0.0f; // of solid angles around `half` over those around `in`
    if (isSolid_) {
        const float behind = Dot(in, half);
        if (!(behind < 0.0f)) return {Float3(0.0f), 0.0f};
        const float root = eta_ * cosine + behind;
        density = -behind / (root * root); // Walter 2007, equation 17
    } else {
        density = 1.0f / (4.0f * std::max(cosine, kSmallestCosine));
    }
    const float pdf = ggxVisibleNormalPdf(half, view_, alpha_, alpha_) * density;
    const float passing = 1.0f - passingDielectric(cosine);
    return {passingColor_ * (passing * pdf * shadowing(-in.z, in)), passingProbability_ * pdf};
}

/// Chooses the direction to which a microfacet turns the view. False if it reflects all of it, or
/// if that is not on the other side.
bool Bxdf::samplePassing(Float2 xi, Float3& in, BxdfValue& value) const {
    const Float3 half = squareToGgxVisibleNormal(xi, view_, alpha_, alpha_);
    const float cosine = Dot(view_, half);
    if (isSolid_) {
        const float behindSquared = 1.0f - eta_ * eta_ * (1.0f - cosine) * (1.0f + cosine);
        if (!(behindSquared > 0.0f)) return false;
        in = half * (eta_ * cosine - std::sqrt(behindSquared)) - view_ * eta_;
    } else {
        in = mirrored(RixReflect(view_, half));
    }
    if (!(in.z < 0.0f)) return false;
    value = passingBy(half, in);
    return true;
}

BxdfValue Bxdf::evaluate(Float3 direction) const {
    const Float3 in = toLocal(direction);
    BxdfValue result = evaluateLocal(in);
    if (isBehind(direction) == (in.z > 0.0f)) result.value = Float3(0.0f);
    return result;
}

bool Bxdf::sample(Float2 xi, BxdfSample& sample) const {
    Float3 in;
    BxdfValue value{Float3(0.0f), 0.0f};
    if (RixChooseAndRemap(xi.x, specularProbability_) == 0) {
        const Float3 half = squareToGgxVisibleNormal(xi, view_, alpha_, alpha_);
        in = RixReflect(view_, half);
    } else if (letsPass() &&
               RixChooseAndRemap(xi.x, passingProbability_ / (1.0f - specularProbability_)) == 0) {
        if (!samplePassing(xi, in, value)) return false;
    } else {
        in = squareToHemisphereCosine(xi);
    }
    sample.direction = toWorld(in);
    sample.direction.Normalize();
    if (isBehind(sample.direction) == (in.z > 0.0f)) return false;
    if (in.z > 0.0f) value = evaluateLocal(in);
    if (!(value.pdf > 0.0f) || isBlack(value.value)) return false;
    sample.weight = value.value / value.pdf;
    sample.pdf = value.pdf;
    return true;
}

} // namespace wellstrat::render
