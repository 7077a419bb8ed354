// SPDX-License-Identifier: Apache-2.0
//
// A sphere light above a diffuse plane: every pixel has a closed form.
//
// A point of the plane at distance d from the center of a sphere of radius R and radiance L, the
// center at height h >= R above the plane, gets the irradiance pi L (R / d)^2 (h / d), for the
// whole sphere is above its horizon: the projected solid angle of a sphere is that of the disk
// which covers it, pi (R / d)^2 times the cosine to its middle. A Lambertian plane of albedo rho
// returns the radiance
//
//     rho L R^2 h / d^3
//
// The plane is so large that its border is out of sight, the sphere reflects nothing, and it stands
// just above the picture. So this is the answer for each point that a pixel sees, at any depth.

#include "../framing.h"
#include "makers.h"
#include "parts.h"

namespace wellstrat::render {

Scene sphereLightScene() {
    Scene scene;
    const uint32_t diffuse = addMaterial(scene, lambertian(Float3(0.6f, 0.7f, 0.8f)));
    const uint32_t light = addMaterial(scene, emitter(Float3(20.0f)));
    addQuads(scene, {rectangle(Float3(0.0f), {0, 0, 100}, {100, 0, 0})}, diffuse);
    scene.spheres.push_back({{0, 2, 0}, 0.5f, light, {}});
    scene.camera = lookAt({0, 5, 6}, {0, 0, 2.5f}, {0, 1, 0}, radians(40));
    return scene;
}

} // namespace wellstrat::render
