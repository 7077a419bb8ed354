// SPDX-License-Identifier: Apache-2.0
#include "bxdf.h"

#include "color.h"

#include <RixShadingUtils.h>

#include <algorithm>

namespace wellstrat::render {

namespace {

/// Smoother surfaces than this would need more than single precision.
constexpr float kSmallestAlpha = 0x1p-10f;

/// Views at a smaller cosine to the shading normal bend it towards them.
constexpr float kSmallestCosine = 0x1p-10f;

/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", equation 15. What
/// reflects less than 4 % at normal incidence reflects less than all at grazing incidence, down to
/// nothing at all.
struct Schlick {
    float f0;

    float f90() const { return std::min(1.0f, 25.0f * f0); }
    float at(float cosine) const {
        const float x = std::max(0.0f, 1.0f - cosine);
        return f0 + (f90() - f0) * (x * x) * (x * x) * x;
    }
    /// The mean over the hemisphere, by the cosine.
    float mean() const { return f0 + (f90() - f0) * (1.0f / 21.0f); }
};

Float3 schlick(Float3 f0, float cosine) {
    // One grazing value for all channels: the color fades away there.
    const float f90 = Schlick{largestChannel(f0)}.f90();
    const float x = std::max(0.0f, 1.0f - cosine);
    return lerp(f0, Float3(f90), (x * x) * (x * x) * x);
}

} // namespace

Bxdf::Bxdf(const Material& material, const SurfaceAttributes& attributes, Float3 geometricNormal,
           Float3 shadingNormal, Float3 view) {
    Float3 color = multiply(material.baseColor, attributes.color);
    if (material.baseColorTexture)
        color = multiply(color, material.baseColorTexture.lookup(attributes));
    color = clamp01(color);
    float metallic = material.metallic;
    float roughness = material.roughness;
    if (material.metallicRoughnessTexture) {
        const Float3 factors = material.metallicRoughnessTexture.lookup(attributes);
        roughness *= factors.y;
        metallic *= factors.z;
    }
    metallic = clamp01(metallic);
    roughness = clamp01(roughness);

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

    alpha_ = std::max(roughness * roughness, kSmallestAlpha);
    Float3 dielectricF0 = material.specularColor * material.specularF0;
    if (material.specularColorTexture)
        dielectricF0 = multiply(dielectricF0, material.specularColorTexture.lookup(attributes));
    if (material.specularTexture) dielectricF0 *= material.specularTexture.lookup(attributes).x;
    dielectricF0 = clamp01(dielectricF0);
    // The diffuse lobe is white behind the interface: what the brightest channel loses, all lose.
    const Schlick dielectric{largestChannel(dielectricF0)};
    dielectricF0_ = dielectric.f0;
    f0_ = lerp(dielectricF0, color, metallic);
    const float transmitted = 1.0f - dielectric.at(view_.z);
    const Float3 diffuseAlbedo = color * ((1.0f - metallic) * transmitted);
    diffuse_ = diffuseAlbedo * (F_INVPI / std::max(1.0f - dielectric.mean(), 0x1p-20f));

    const float diffuseShare = largestChannel(diffuseAlbedo);
    const float specularShare = largestChannel(schlick(f0_, view_.z));
    const float both = diffuseShare + specularShare;
    specularProbability_ = both > 0.0f ? specularShare / both : 0.0f;
}

BxdfValue Bxdf::evaluateLocal(Float3 in) const {
    BxdfValue result{Float3(0.0f), 0.0f};
    if (!(in.z > 0.0f)) return result;
    if (specularProbability_ < 1.0f) {
        result.value = diffuse_ * (in.z * (1.0f - Schlick{dielectricF0_}.at(in.z)));
        result.pdf = (1.0f - specularProbability_) * hemisphereCosinePdf(in.z);
    }
    if (specularProbability_ > 0.0f) {
        Float3 half = in + view_;
        half.Normalize();
        const float cosine = std::max(Dot(view_, half), kSmallestCosine);
        const float normalPdf = ggxVisibleNormalPdf(half, view_, alpha_, alpha_);
        const float pdf = normalPdf / (4.0f * cosine);
        // The visible normals have the masking of the view in them; what is left is the ratio of
        // the masking and shadowing of both to it, Heitz 2014, equations 43 and 99.
        const auto scaled = [this](Float3 v) {
            return Float3(alpha_ * v.x, alpha_ * v.y, v.z).Length();
        };
        const float viewLength = scaled(view_);
        const float shadowing =
            in.z * (view_.z + viewLength) / (in.z * viewLength + view_.z * scaled(in));
        result.value += schlick(f0_, cosine) * (pdf * shadowing);
        result.pdf += specularProbability_ * pdf;
    }
    return result;
}

BxdfValue Bxdf::evaluate(Float3 direction) const {
    BxdfValue result = evaluateLocal(toLocal(direction));
    if (!(Dot(direction, geometricNormal_) > 0.0f)) result.value = Float3(0.0f);
    return result;
}

bool Bxdf::sample(Float2 xi, BxdfSample& sample) const {
    Float3 in;
    if (RixChooseAndRemap(xi.x, specularProbability_) == 0) {
        const Float3 half = squareToGgxVisibleNormal(xi, view_, alpha_, alpha_);
        in = RixReflect(view_, half);
    } else {
        in = squareToHemisphereCosine(xi);
    }
    sample.direction = toWorld(in);
    sample.direction.Normalize();
    if (!(Dot(sample.direction, geometricNormal_) > 0.0f)) return false;
    const BxdfValue value = evaluateLocal(in);
    if (!(value.pdf > 0.0f) || isBlack(value.value)) return false;
    sample.weight = value.value / value.pdf;
    sample.pdf = value.pdf;
    return true;
}

} // namespace wellstrat::render
