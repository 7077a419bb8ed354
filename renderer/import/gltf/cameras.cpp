// SPDX-License-Identifier: Apache-2.0

#include "cameras.h"
#include "../../framing.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace wellstrat::render {
namespace {

/// Orthographic cameras have this field of view when they are made perspective.
constexpr float kOtherFov = 0.6f;

bool isUsable(double size) { return std::isfinite(size) && size != 0; }

NamedCamera cameraAt(const tinygltf::Camera& source, const Affine& toWorld) {
    const bool isOrthographic = source.type == "orthographic";
    const auto& perspective = source.perspective;
    const auto fov = isOrthographic ? kOtherFov : static_cast<float>(perspective.yfov);
    NamedCamera result;
    result.camera = lookAlong(toWorld.origin, -toWorld.z, toWorld.y, fov);
    if (isOrthographic) {
        const double width = source.orthographic.xmag, height = source.orthographic.ymag;
        if (!isUsable(width) || !isUsable(height))
            throw std::invalid_argument("an orthographic camera must have a width and a height");
        result.camera.orthographicHeight = static_cast<float>(2 * std::abs(height));
        result.aspect = static_cast<float>(std::abs(width / height));
    } else if (perspective.aspectRatio > 0 && std::isfinite(perspective.aspectRatio)) {
        result.aspect = static_cast<float>(perspective.aspectRatio);
    }
    return result;
}

} // namespace

std::vector<NamedCamera> importCameras(const GltfDocument& document,
                                       const std::vector<GltfInstance>& cameras, Notes& notes) {
    std::vector<NamedCamera> result;
    for (const GltfInstance& instance : cameras) {
        const tinygltf::Camera& source = at(document.model().cameras, instance.number, "camera");
        const std::string& name = instance.node->name.empty() ? source.name : instance.node->name;
        try {
            result.push_back(cameraAt(source, instance.toWorld));
            result.back().name = name;
            result.back().otherName = source.name;
        } catch (const std::invalid_argument& error) {
            notes.add(fmt::format("The camera '{}' is left out: {}.", name, error.what()));
        }
    }
    return result;
}

} // namespace wellstrat::render
