// SPDX-License-Identifier: Apache-2.0
#include "lights.h"

#include "emission.h"
#include "framing.h"
#include "geometry.h"
#include "light_power.h"
#include "opacity.h"
#include "shapes.h"
#include "sphere_directions.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

constexpr uint32_t kNoLight = ~0u;

/// What a point chosen evenly on `area` has per unit solid angle.
float solidAnglePdf(float area, float distanceSq, float cosine) {
    return distanceSq / (area * std::fabs(cosine));
}

/// Half by power, half all alike: power alone would neglect lamps for a far sun.
DiscreteDistribution choiceByPower(std::vector<double> weights) {
    double total = 0.0;
    double count = 0.0;
    for (double& weight : weights) {
        if (!(weight > 0.0)) weight = 0.0; // NaN too
        weight = std::min(weight, 1e100);
        total += weight;
        count += weight > 0.0 ? 1.0 : 0.0;
    }
    for (double& weight : weights) {
        if (weight > 0.0) weight = 0.5 * weight / total + 0.5 / count;
    }
    return DiscreteDistribution(weights);
}

/// What is left of a spot's intensity in this direction: glTF, KHR_lights_punctual.
float spotFalloff(const PunctualLight& light, Float3 direction) {
    const float scale = 1.0f / std::max(0.001f, light.cosInner - light.cosOuter);
    const float t = clamp01((Dot(direction, light.direction) - light.cosOuter) * scale);
    return t * t;
}

/// What the range of a light leaves of it at this distance: glTF, KHR_lights_punctual.
float rangeFalloff(const PunctualLight& light, float distance) {
    const float part = distance / light.range;
    return clamp01(1.0f - (part * part) * (part * part));
}

/// Does it give off the same light everywhere?
bool isUniformLight(const Material& material) {
    return !material.emissionTexture && !material.colorIsEmission &&
           material.alpha == Material::Alpha::opaque;
}

} // namespace

Lights::Lights(const Scene& scene)
    : scene_(scene), firstOfMesh_(scene.meshes.size(), kNoLight),
      ofSphere_(scene.spheres.size(), kNoLight) {
    std::vector<double> power;
    const auto add = [&](Light light, double itsPower) {
        lights_.push_back(light);
        power.push_back(itsPower);
        return static_cast<uint32_t>(lights_.size() - 1);
    };
    for (uint32_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        const Material& material = scene.materials[mesh.material];
        if (!emits(material)) continue;
        firstOfMesh_[i] = static_cast<uint32_t>(lights_.size());
        for (uint32_t j = 0; j < mesh.triangles.size(); ++j) {
            add({Kind::triangle, i, j}, trianglePower(mesh, j, material));
        }
    }
    for (uint32_t i = 0; i < scene.spheres.size(); ++i) {
        const Material& material = scene.materials[scene.spheres[i].material];
        if (!emits(material)) continue;
        ofSphere_[i] = add({Kind::sphere, i, 0}, spherePower(scene.spheres[i], material));
    }
    const float radius = scene.lights.empty() ? 0.0f : sceneBounds(scene).radius();
    for (uint32_t i = 0; i < scene.lights.size(); ++i) {
        add({Kind::punctual, i, 0}, punctualPower(scene.lights[i], radius));
    }
    choice_ = choiceByPower(std::move(power));
}

bool Lights::sample(const SurfacePoint& receiver, float time, Float2 xi,
                    LightSample& sample) const {
    const std::size_t number = choice_.choose(xi.x);
    const Light& light = lights_[number];
    sample.pdf = static_cast<float>(choice_.probability(number));
    sample.punctual = light.kind == Kind::punctual;
    const bool found =
        light.kind == Kind::triangle ? sampleTriangle(light, receiver, time, xi, sample)
        : light.kind == Kind::sphere ? sampleSphere(light, receiver, time, xi, sample)
                                     : samplePunctual(light, receiver, time, sample);
    return found && !isBlack(sample.radiance) && std::isfinite(sample.pdf) && sample.pdf > 0.0f;
}

bool Lights::sampleTriangle(const Light& light, const SurfacePoint& receiver, float time, Float2 xi,
                            LightSample& sample) const {
    const Mesh& mesh = scene_.meshes[light.shape];
    const Triangle triangle = triangleAt(mesh, light.primitive, time);
    const Float2 weight = squareToTriangle(xi);
    const SurfacePoint point = trianglePoint(triangle, weight.x, weight.y, Float3(0.0f));
    sample.direction = point.position - receiver.position;
    const float distance = sample.direction.Normalize();
    const float cosine = -Dot(point.normal, sample.direction);
    if (!(distance > 0.0f) || cosine == 0.0f) return false;
    const Material& material = scene_.materials[mesh.material];
    SurfaceAttributes attributes;
    if (!isUniformLight(material))
        attributes = triangleAttributes(mesh, light.primitive, weight.x, weight.y);
    sample.radiance = emittedRadiance(material, attributes, point.normal, -sample.direction);
    if (material.alpha != Material::Alpha::opaque)
        sample.radiance *= opacityAt(material, attributes);
    sample.shadowRay = connect(receiver, point, time);
    sample.pdf *= solidAnglePdf(0.5f * triangle.areaNormal().Length(), distance * distance, cosine);
    return true;
}

bool Lights::sampleSphere(const Light& light, const SurfacePoint& receiver, float time, Float2 xi,
                          LightSample& sample) const {
    const Sphere& sphere = scene_.spheres[light.shape];
    const SphereDirections directions(centerAt(sphere, time) - receiver.position, sphere.radius);
    sample.direction = directions.sample(xi);
    const SurfacePoint point = spherePoint(
        sphere, receiver.position + sample.direction * directions.distance(sample.direction), time);
    sample.radiance =
        emittedRadiance(scene_.materials[sphere.material], {sphereUv(point.normal)}, point.normal,
                        directions.inside() ? -point.normal : point.normal);
    sample.shadowRay = connect(receiver, point, time);
    sample.pdf *= directions.pdf(sample.direction);
    return true;
}

bool Lights::samplePunctual(const Light& light, const SurfacePoint& receiver, float time,
                            LightSample& sample) const {
    const PunctualLight& punctual = scene_.lights[light.shape];
    if (punctual.kind == PunctualLight::Kind::directional) {
        sample.direction = -punctual.direction;
        sample.radiance = punctual.intensity;
        sample.shadowRay = leave(receiver, sample.direction, time);
        return true;
    }
    sample.direction = punctual.position - receiver.position;
    const float distance = sample.direction.Normalize();
    if (!(distance > 0.0f)) return false;
    sample.radiance =
        punctual.intensity * (rangeFalloff(punctual, distance) / (distance * distance));
    if (punctual.kind == PunctualLight::Kind::spot) {
        sample.radiance *= spotFalloff(punctual, -sample.direction);
    }
    sample.shadowRay = connect(receiver, {punctual.position, Float3(0.0f), 0.0f}, time);
    return true;
}

float Lights::pdf(const Ray& ray, const Hit& hit, const Surface& surface) const {
    if (hit.shape == scene_.meshes.size()) {
        const uint32_t number = ofSphere_[hit.primitive];
        if (number == kNoLight) return 0.0f;
        const Sphere& sphere = scene_.spheres[hit.primitive];
        const SphereDirections directions(centerAt(sphere, ray.time) - ray.origin, sphere.radius);
        return static_cast<float>(choice_.probability(number)) * directions.pdf(ray.direction);
    }
    const uint32_t first = firstOfMesh_[hit.shape];
    if (first == kNoLight) return 0.0f;
    const Triangle triangle = triangleAt(scene_.meshes[hit.shape], hit.primitive, ray.time);
    const float cosine = Dot(surface.point.normal, ray.direction);
    const float pdf =
        solidAnglePdf(0.5f * triangle.areaNormal().Length(), hit.distance * hit.distance, cosine);
    return static_cast<float>(choice_.probability(first + hit.primitive)) * pdf;
}

} // namespace wellstrat::render
