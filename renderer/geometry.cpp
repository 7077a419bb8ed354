// SPDX-License-Identifier: Apache-2.0
#include "geometry.h"

#include "embree_spheres.h"
#include "opacity.h"
#include "shapes.h"

#include <RixRNG.h>
#include <embree3/rtcore.h>

#include <cstring>
#include <stdexcept>
#include <string>

namespace wellstrat::render {

namespace {

void fillVertices(RTCGeometry geometry, unsigned timeStep, const std::vector<Float3>& positions) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, timeStep,
                                           RTC_FORMAT_FLOAT3, sizeof(Float3), positions.size());
    if (buffer) std::memcpy(buffer, positions.data(), positions.size() * sizeof(Float3));
}

RTCGeometry makeTriangles(RTCDevice device, const Mesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const bool moves = !mesh.positionsAtEnd.empty();
    rtcSetGeometryTimeStepCount(geometry, moves ? 2 : 1);
    fillVertices(geometry, 0, mesh.positions);
    if (moves) fillVertices(geometry, 1, mesh.positionsAtEnd);
    const std::size_t count = mesh.triangles.size();
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.triangles[0]), count);
    if (indices) std::memcpy(indices, mesh.triangles.data(), count * sizeof(mesh.triangles[0]));
    return geometry;
}

void attach(RTCScene scene, RTCGeometry geometry, std::size_t number) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(number));
    rtcReleaseGeometry(geometry);
}

RTCRay embreeRay(const Ray& ray) {
    RTCRay result;
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.tnear = 0.0f;
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.time = ray.time;
    result.tfar = ray.maxDistance;
    result.mask = ~0u;
    result.id = 0;
    result.flags = 0;
    return result;
}

/// Of what may be not all there.
float opacityOf(const Scene& scene, const RTCHit& hit) {
    if (hit.geomID >= scene.meshes.size()) return 1.0f;
    const Mesh& mesh = scene.meshes[hit.geomID];
    const Material& material = scene.materials[mesh.material];
    if (material.alpha == Material::Alpha::opaque) return 1.0f;
    return opacityAt(material, triangleAttributes(mesh, hit.primID, hit.u, hit.v));
}

/// A search for the closest hit, for callbacks that have a ClosestHit.
struct Search : ClosestHit {
    const Scene* scene;
    uint32_t chance;

    /// Independent for each surface, and the same in whichever order Embree visits them.
    bool passes(const RTCHit& hit) const {
        const float opacity = opacityOf(*scene, hit);
        if (opacity >= 1.0f) return false;
        return !(HashToRandom(chance ^ hit.geomID * 0x9e3779b9u, hit.primID) < opacity);
    }
};

/// Embree calls this for each hit that is no farther than the closest so far.
template <bool kHasHoles>
void keepFirst(const RTCFilterFunctionNArguments* arguments) {
    auto& search = static_cast<Search&>(*reinterpret_cast<ClosestHit*>(arguments->context));
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    if ((kHasHoles && search.passes(hit)) || !search.offer(ray.tfar, hit.geomID, hit.primID))
        arguments->valid[0] = 0;
}

/// Light on its way through all that lets some of it pass.
struct Passage {
    RTCIntersectContext context; ///< first, so that callbacks find the rest
    const Scene* scene;
    float transmittance = 1;
};

/// Embree calls this for each hit, until one is not refused.
void dim(const RTCFilterFunctionNArguments* arguments) {
    auto& passage = *reinterpret_cast<Passage*>(arguments->context);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    passage.transmittance *= 1.0f - opacityOf(*passage.scene, hit);
    if (passage.transmittance > 0.0f) arguments->valid[0] = 0;
}

} // namespace

struct Geometry::Embree {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);

    Embree() {
        rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                           RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    }
    ~Embree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
};

Geometry::Geometry(const Scene& scene) : scene_(scene) {
    for (const Mesh& mesh : scene.meshes) {
        const Material::Alpha alpha = scene.materials[mesh.material].alpha;
        hasHoles_ = hasHoles_ || alpha != Material::Alpha::opaque;
        isBlended_ = isBlended_ || alpha == Material::Alpha::blend;
        const bool isUniform = mesh.colors.empty() && !isTextured(scene.materials[mesh.material]);
        isUniform_.push_back(isUniform ? 1 : 0);
    }
    auto embree = std::make_unique<Embree>();
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        if (scene.meshes[i].triangles.empty()) continue;
        attach(embree->scene, makeTriangles(embree->device, scene.meshes[i]), i);
    }
    if (!scene.spheres.empty()) {
        attach(embree->scene, makeSpheres(embree->device, scene.spheres), scene.meshes.size());
    }
    rtcCommitScene(embree->scene);
    const RTCError error = rtcGetDeviceError(embree->device);
    if (error != RTC_ERROR_NONE) {
        throw std::runtime_error(error == RTC_ERROR_OUT_OF_MEMORY
                                     ? "not enough memory for the geometry of the scene"
                                     : "Embree refused the scene, error " + std::to_string(error));
    }
    embree_ = std::move(embree);
}

Geometry::~Geometry() = default;

bool Geometry::closestHit(const Ray& ray, Hit& hit) const {
    Search closest;
    rtcInitIntersectContext(&closest.context);
    closest.context.filter = hasHoles_ ? keepFirst<true> : keepFirst<false>;
    closest.scene = &scene_;
    closest.chance = ray.chance;
    RTCRayHit result;
    result.ray = embreeRay(ray);
    result.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &closest.context, &result);
    if (result.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit = {result.hit.geomID, result.hit.primID, result.hit.u, result.hit.v, result.ray.tfar};
    return true;
}

float Geometry::transmittance(const Ray& ray) const {
    Passage passage;
    rtcInitIntersectContext(&passage.context);
    passage.scene = &scene_;
    if (hasHoles_) passage.context.filter = dim;
    RTCRay result = embreeRay(ray);
    rtcOccluded1(embree_->scene, &passage.context, &result);
    return result.tfar < 0.0f ? 0.0f : passage.transmittance;
}

Surface Geometry::surface(const Ray& ray, const Hit& hit) const {
    Surface surface;
    if (hit.shape == scene_.meshes.size()) {
        const Sphere& sphere = scene_.spheres[hit.primitive];
        surface.point = spherePoint(sphere, ray.origin + ray.direction * hit.distance, ray.time);
        surface.shadingNormal = surface.point.normal;
        surface.material = &scene_.materials[sphere.material];
        surface.isUniform = !isTextured(*surface.material);
        if (!surface.isUniform) surface.attributes.uv = sphereUv(surface.point.normal);
        return surface;
    }
    const Mesh& mesh = scene_.meshes[hit.shape];
    const Triangle triangle = triangleAt(mesh, hit.primitive, ray.time);
    surface.point = trianglePoint(triangle, hit.u, hit.v, -ray.direction);
    surface.shadingNormal = surface.point.normal;
    surface.isUniform = isUniform_[hit.shape] != 0;
    if (!surface.isUniform)
        surface.attributes = triangleAttributes(mesh, hit.primitive, hit.u, hit.v);
    surface.material = &scene_.materials[mesh.material];
    if (!mesh.normals.empty()) {
        surface.shadingNormal =
            normalizedOr(interpolate(mesh.normals, mesh.triangles[hit.primitive], hit.u, hit.v),
                         surface.point.normal);
    }
    if (!surface.isUniform && surface.material->normalTexture) {
        surface.shadingNormal = mappedNormal(mesh, hit.primitive, triangle, *surface.material,
                                             surface.attributes, surface.shadingNormal);
    }
    return surface;
}

} // namespace wellstrat::render
