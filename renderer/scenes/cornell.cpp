// SPDX-License-Identifier: Apache-2.0
//
// The Cornell box. All numbers are those of Cornell University Program of Computer Graphics,
// "Cornell Box Data", 2005, https://www.graphics.cornell.edu/online/box/data.html: camera, geometry
// (in millimeters), spectra (cornell_colors.cpp). The light reflects 0.78 of what it gets. The
// ceiling has a hole where the light is, so that no two surfaces lie upon each other. x points to
// the left of the picture.

#include "../framing.h"
#include "cornell_colors.h"
#include "makers.h"
#include "parts.h"

#include <cmath>

namespace wellstrat::render {
namespace {

constexpr float kWidth = 556.0f, kHeight = 548.8f, kDepth = 559.2f;
constexpr float kLightX0 = 213, kLightX1 = 343, kLightZ0 = 227, kLightZ1 = 332;

/// A rectangle of the ceiling, seen from below.
Quad ceiling(float x0, float x1, float z0, float z1) {
    return {Float3(x1, kHeight, z0), Float3(x1, kHeight, z1), Float3(x0, kHeight, z1),
            Float3(x0, kHeight, z0)};
}

/// The top and the four sides of a block whose top has these corners (x, z).
std::vector<Quad> block(float height, const std::array<Float2, 4>& corners) {
    const auto at = [&](std::size_t i, float y) {
        return Float3(corners[i % 4].x, y, corners[i % 4].y);
    };
    std::vector<Quad> sides{{at(0, height), at(1, height), at(2, height), at(3, height)}};
    for (std::size_t i = 0; i < 4; ++i)
        sides.push_back({at(i, height), at(i, 0), at(i + 1, 0), at(i + 1, height)});
    return sides;
}

} // namespace

Scene cornellScene() {
    const CornellColors colors = cornellColors();
    Scene scene;
    const uint32_t white = addMaterial(scene, lambertian(colors.white));
    const uint32_t red = addMaterial(scene, lambertian(colors.red));
    const uint32_t green = addMaterial(scene, lambertian(colors.green));
    Material lamp = lambertian(Float3(0.78f));
    lamp.emission = colors.light;
    const uint32_t light = addMaterial(scene, lamp);

    const Float3 floorFrontLeft(552.8f, 0, 0), floorFrontRight(0, 0, 0);
    const Float3 floorBackLeft(549.6f, 0, kDepth), floorBackRight(0, 0, kDepth);
    const Float3 topFrontLeft(kWidth, kHeight, 0), topFrontRight(0, kHeight, 0);
    const Float3 topBackLeft(kWidth, kHeight, kDepth), topBackRight(0, kHeight, kDepth);
    addQuads(scene,
             {{floorFrontLeft, floorFrontRight, floorBackRight, floorBackLeft},
              {floorBackLeft, floorBackRight, topBackRight, topBackLeft},
              ceiling(0, kWidth, 0, kLightZ0),
              ceiling(0, kWidth, kLightZ1, kDepth),
              ceiling(0, kLightX0, kLightZ0, kLightZ1),
              ceiling(kLightX1, kWidth, kLightZ0, kLightZ1)},
             white);
    addQuads(scene, {{floorFrontLeft, floorBackLeft, topBackLeft, topFrontLeft}}, red);
    addQuads(scene, {{floorBackRight, floorFrontRight, topFrontRight, topBackRight}}, green);
    addQuads(scene, {ceiling(kLightX0, kLightX1, kLightZ0, kLightZ1)}, light);
    addQuads(scene, block(165, {{{130, 65}, {82, 225}, {240, 272}, {290, 114}}}), white);
    addQuads(scene, block(330, {{{423, 247}, {265, 296}, {314, 456}, {472, 406}}}), white);

    // A lens of 35 mm before a film of 25 mm x 25 mm.
    scene.camera =
        lookAt({278, 273, -800}, {278, 273, 0}, {0, 1, 0}, 2 * std::atan(0.025f / (2 * 0.035f)));
    return scene;
}

} // namespace wellstrat::render
