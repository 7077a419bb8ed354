// SPDX-License-Identifier: Apache-2.0
//
// All lights of a scene but the environment: emissive triangles and spheres, and punctual lights.
// One is chosen by its power, then a point on it.

#pragma once

#include "discrete_distribution.h"
#include "ray.h"
#include "scene.h"

#include <cstdint>
#include <vector>

namespace wellstrat::render {

struct Hit;
struct Surface;

/// Light that may arrive at a point, if nothing is in its way.
struct LightSample {
    Float3 radiance;  ///< punctual lights: irradiance on a plane across `direction`
    Float3 direction; ///< to the light, unit length
    Ray shadowRay;
    /// Of the choice of the light and the point, per unit solid angle; punctual lights: of the
    /// choice alone.
    float pdf;
    bool punctual; ///< no ray could hit it by chance
};

/// The lights of a scene, which must outlive this. Immutable; safe in any thread.
class Lights {
public:
    explicit Lights(const Scene& scene);

    bool empty() const { return !(choice_.total() > 0.0); }

    /// Chooses a light with xi.x, and with all of xi a point on it. Returns false if no light comes
    /// from there. Must not be called if empty().
    bool sample(const SurfacePoint& receiver, float time, Float2 xi, LightSample& sample) const;

    /// The density, as LightSample::pdf, with which `sample` would choose for a receiver at
    /// ray.origin what `ray` hit there. 0 if it is no light.
    float pdf(const Ray& ray, const Hit& hit, const Surface& surface) const;

private:
    enum class Kind : uint8_t { triangle, sphere, punctual };
    struct Light {
        Kind kind;
        uint32_t shape; ///< the number of the mesh, sphere or punctual light
        uint32_t primitive;
    };

    bool sampleTriangle(const Light& light, const SurfacePoint& receiver, float time, Float2 xi,
                        LightSample& sample) const;
    bool sampleSphere(const Light& light, const SurfacePoint& receiver, float time, Float2 xi,
                      LightSample& sample) const;
    bool samplePunctual(const Light& light, const SurfacePoint& receiver, float time,
                        LightSample& sample) const;

    const Scene& scene_;
    std::vector<Light> lights_;
    std::vector<uint32_t> firstOfMesh_; ///< the number of the light of its triangle 0
    std::vector<uint32_t> ofSphere_;
    DiscreteDistribution choice_;
};

} // namespace wellstrat::render
