// SPDX-License-Identifier: Apache-2.0
#include "light_power.h"

#include "shapes.h"

#include <RixShadingUtils.h>

namespace wellstrat::render {

namespace {

/// Of an area whose mean radiance is `radiance`.
double areaPower(const Material& material, Float3 radiance, double area) {
    const double sides = material.doubleSided ? 2.0 : 1.0;
    return sides * area * F_PI * luminance(radiance);
}

/// The mean of a texture over a triangle, by the middles of 4 x 4 cells.
Float3 meanTexture(const Mesh& mesh, uint32_t primitive, const TextureMap& texture) {
    constexpr float kCell = 0.25f;
    Float3 sum(0.0f);
    for (float x = 0.5f * kCell; x < 1.0f; x += kCell) {
        for (float y = 0.5f * kCell; y < 1.0f; y += kCell) {
            const Float2 weight = squareToTriangle({x, y});
            sum += texture.lookup(triangleAttributes(mesh, primitive, weight.x, weight.y));
        }
    }
    return sum * (kCell * kCell);
}

} // namespace

double trianglePower(const Mesh& mesh, uint32_t primitive, const Material& material) {
    Float3 radiance = material.emission;
    if (material.emissionTexture)
        radiance = multiply(radiance, meanTexture(mesh, primitive, material.emissionTexture));
    const double area = 0.5 * triangleAt(mesh, primitive, 0.0f).areaNormal().Length();
    return areaPower(material, radiance, area);
}

double spherePower(const Sphere& sphere, const Material& material) {
    return areaPower(material, material.emission, 2.0 * F_TWOPI * sphere.radius * sphere.radius);
}

double punctualPower(const PunctualLight& light, float sceneRadius) {
    const double intensity = luminance(light.intensity);
    switch (light.kind) {
    case PunctualLight::Kind::point: return 2.0 * F_TWOPI * intensity;
    case PunctualLight::Kind::spot:
        return F_TWOPI * intensity * (1.0 - 0.5 * (light.cosInner + light.cosOuter));
    case PunctualLight::Kind::directional: break;
    }
    return F_PI * sceneRadius * sceneRadius * intensity;
}

} // namespace wellstrat::render
