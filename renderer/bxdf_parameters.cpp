// SPDX-License-Identifier: Apache-2.0
#include "bxdf_parameters.h"

#include "color.h"
#include "schlick.h"

#include <RixShadingUtils.h>

#include <algorithm>

namespace wellstrat::render {

namespace {

/// Smoother surfaces than this would need more than single precision.
constexpr float kSmallestAlpha = 0x1p-10f;

/// What refracts less turns rays by less than single precision can tell microfacets by.
constexpr float kSmallestIor = 1 + 0x1p-8f;
constexpr float kLargestIor = 100;

/// NaN counts as too small.
float indexInRange(float ior) {
    return ior > kSmallestIor ? std::min(ior, kLargestIor) : kSmallestIor;
}

} // namespace

BxdfParameters bxdfParameters(const Material& material, const SurfaceAttributes& attributes) {
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
    Float3 dielectricF0 = material.specularColor * material.specularF0;
    if (material.specularColorTexture)
        dielectricF0 = multiply(dielectricF0, material.specularColorTexture.lookup(attributes));
    if (material.specularTexture) dielectricF0 *= material.specularTexture.lookup(attributes).x;
    dielectricF0 = clamp01(dielectricF0);

    BxdfParameters result;
    result.alpha = std::max(roughness * roughness, kSmallestAlpha);
    // The diffuse lobe is white behind the interface: what the brightest channel loses, all lose.
    const Schlick dielectric{largestChannel(dielectricF0)};
    result.dielectricF0 = dielectric.f0;
    result.f0 = lerp(dielectricF0, color, metallic);
    result.diffuseColor = color * (1.0f - metallic);
    result.diffuseScale = F_INVPI / std::max(1.0f - dielectric.mean(), 0x1p-20f);

    float transmission = material.transmission;
    if (material.transmissionTexture)
        transmission *= material.transmissionTexture.lookup(attributes).x;
    transmission = clamp01(transmission);
    if (transmission > 0.0f && metallic < 1.0f) {
        result.passingColor = result.diffuseColor * transmission;
        result.diffuseColor *= 1.0f - transmission;
        result.ior = indexInRange(material.ior);
        const float root = (result.ior - 1.0f) / (result.ior + 1.0f);
        result.diffuseScale = F_INVPI / (1.0f - root * root); // at most, on both sides
        result.f0 = color;
        result.metallic = metallic;
        result.isSolid = material.isSolid;
    }
    return result;
}

} // namespace wellstrat::render
