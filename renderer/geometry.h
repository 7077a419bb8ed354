// SPDX-License-Identifier: Apache-2.0
//
// What rays hit, by Embree.

#pragma once

#include "ray.h"
#include "scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace wellstrat::render {

/// Which point of which shape a ray hit.
struct Hit {
    uint32_t shape;     ///< the number of the mesh, or scene.meshes.size() for spheres
    uint32_t primitive; ///< the number of the triangle or sphere
    float u, v;         ///< of triangles: the weights of the second and the third corner
    float distance;
};

/// All about the point that was hit.
struct Surface {
    SurfacePoint point;
    Float3 shadingNormal; ///< unit length
    const Material* material;
    bool isUniform; ///< the material is the same everywhere: it does not depend on the attributes
    SurfaceAttributes attributes; ///< not looked up if it is
};

/// The shapes of a scene, which must outlive this. All functions may run in any thread, and what
/// they return depends on nothing but their arguments: of several shapes at exactly the same
/// distance, the first in the scene is hit.
class Geometry {
public:
    /// Throws std::runtime_error if Embree cannot take the scene, usually for lack of memory.
    explicit Geometry(const Scene& scene);
    ~Geometry();
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    /// Finds the closest hit of a ray, at any distance above 0 and below its maxDistance. The ray
    /// passes surfaces of an opacity below 1 by chance, which is in it.
    bool closestHit(const Ray& ray, Hit& hit) const;

    /// Which part of the light passes all that is between 0 and maxDistance.
    float transmittance(const Ray& ray) const;

    /// Does none?
    bool occluded(const Ray& ray) const { return transmittance(ray) == 0.0f; }

    /// Is there anything that lets a part of the light pass?
    bool isBlended() const { return isBlended_; }

    /// The surface at a hit of `ray`. All vectors are finite, whatever the scene holds.
    Surface surface(const Ray& ray, const Hit& hit) const;

private:
    struct Embree;
    const Scene& scene_;
    bool hasHoles_ = false, isBlended_ = false;
    std::vector<uint8_t> isUniform_; ///< by mesh: is 1 where its material needs no attributes
    std::unique_ptr<const Embree> embree_;
};

} // namespace wellstrat::render
