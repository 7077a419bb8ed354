// SPDX-License-Identifier: Apache-2.0
#include "embree_spheres.h"

#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

/// The two distances at which a ray meets a sphere, the smaller first.
struct Roots {
    double first, second;
};

/// Returns false if the ray misses. In double precision, and by the distance of the ray from the
/// center, so that far and large spheres stay round: Haines et al. 2019, "Precision Improvements
/// for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7.
bool intersect(const Sphere& sphere, const RTCRay& ray, Roots& roots) {
    const Float3 center = centerAt(sphere, ray.time);
    const double toCenter[3] = {double{center.x} - ray.org_x, double{center.y} - ray.org_y,
                                double{center.z} - ray.org_z};
    const double direction[3] = {ray.dir_x, ray.dir_y, ray.dir_z};
    double lengthSq = 0.0;
    double along = 0.0;
    for (int i = 0; i < 3; ++i) {
        lengthSq += direction[i] * direction[i];
        along += direction[i] * toCenter[i];
    }
    const double middle = along / lengthSq;
    double asideSq = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double aside = toCenter[i] - middle * direction[i];
        asideSq += aside * aside;
    }
    const double halfChordSq = double{sphere.radius} * sphere.radius - asideSq;
    if (!(halfChordSq >= 0.0)) return false;
    const double half = std::sqrt(halfChordSq / lengthSq);
    roots = {middle - half, middle + half};
    return true;
}

const Sphere& sphereOf(void* spheres, unsigned number) {
    return static_cast<const Sphere*>(spheres)[number];
}

void bounds(const RTCBoundsFunctionArguments* arguments) {
    const Sphere& sphere = sphereOf(arguments->geometryUserPtr, arguments->primID);
    const Float3 center = centerAt(sphere, static_cast<float>(arguments->timeStep));
    // Rounding must not cut off what the test in double precision would hit.
    const float margin =
        0x1p-22f * (std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z));
    const Float3 reach(sphere.radius * (1.0f + 0x1p-22f) + margin);
    const Float3 lower = center - reach;
    const Float3 upper = center + reach;
    *arguments->bounds_o = {lower.x, lower.y, lower.z, 0.0f, upper.x, upper.y, upper.z, 0.0f};
}

void closestHit(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    auto& result = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    auto& closest = *reinterpret_cast<ClosestHit*>(arguments->context);
    Roots roots;
    const Sphere& sphere = sphereOf(arguments->geometryUserPtr, arguments->primID);
    if (!intersect(sphere, result.ray, roots)) return;
    const double root = roots.first > result.ray.tnear ? roots.first : roots.second;
    const auto distance = static_cast<float>(root);
    if (!(distance > result.ray.tnear && distance <= result.ray.tfar)) return;
    if (!closest.offer(distance, arguments->geomID, arguments->primID)) return;
    result.ray.tfar = distance;
    result.hit.geomID = arguments->geomID;
    result.hit.primID = arguments->primID;
    result.hit.u = result.hit.v = 0.0f;
}

void anyHit(const RTCOccludedFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
    Roots roots;
    if (!intersect(sphereOf(arguments->geometryUserPtr, arguments->primID), ray, roots)) return;
    const auto within = [&ray](double t) { return t > ray.tnear && t < ray.tfar; };
    if (within(roots.first) || within(roots.second)) {
        ray.tfar = -std::numeric_limits<float>::infinity();
    }
}

} // namespace

RTCGeometry makeSpheres(RTCDevice device, const std::vector<Sphere>& spheres) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    const bool moves = std::any_of(spheres.begin(), spheres.end(),
                                   [](const Sphere& s) { return s.centerAtEnd.has_value(); });
    rtcSetGeometryTimeStepCount(geometry, moves ? 2 : 1);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres.size()));
    rtcSetGeometryUserData(geometry, const_cast<Sphere*>(spheres.data()));
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, closestHit);
    rtcSetGeometryOccludedFunction(geometry, anyHit);
    return geometry;
}

} // namespace wellstrat::render
