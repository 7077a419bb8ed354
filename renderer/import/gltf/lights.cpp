// SPDX-License-Identifier: Apache-2.0

#include "lights.h"

#include "../../shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wellstrat::render {
namespace {

std::optional<PunctualLight::Kind> kindOf(const tinygltf::Light& light) {
    if (light.type == "point") return PunctualLight::Kind::point;
    if (light.type == "spot") return PunctualLight::Kind::spot;
    if (light.type == "directional") return PunctualLight::Kind::directional;
    return {};
}

/// Without kind.
PunctualLight lightAt(const tinygltf::Light& light, const Affine& toWorld) {
    PunctualLight result{};
    result.position = toWorld.origin;
    // It shines along -z.
    result.direction = normalizedOr(-toWorld.z, Float3(0.0f));
    const bool hasColor = light.color.size() == 3;
    for (int c = 0; c < 3; ++c) {
        const double color = hasColor ? light.color[static_cast<std::size_t>(c)] : 1;
        result.intensity[c] = static_cast<float>(color * light.intensity);
    }
    if (light.range > 0) result.range = static_cast<float>(light.range);
    result.cosInner = std::cos(static_cast<float>(light.spot.innerConeAngle));
    result.cosOuter =
        std::min(std::cos(static_cast<float>(light.spot.outerConeAngle)), result.cosInner);
    return result;
}

bool isUsable(const PunctualLight& light) {
    return isFinite(light.position) && isFinite(light.intensity) && light.range > 0 &&
           (light.kind == PunctualLight::Kind::point || light.direction.LengthSq() > 0) &&
           std::isfinite(light.cosInner) && std::isfinite(light.cosOuter) &&
           light.intensity.x >= 0 && light.intensity.y >= 0 && light.intensity.z >= 0;
}

} // namespace

std::vector<PunctualLight> importLights(const GltfDocument& document,
                                        const std::vector<GltfInstance>& lights, Notes& notes) {
    std::vector<PunctualLight> result;
    for (const GltfInstance& instance : lights) {
        const tinygltf::Light& source = at(document.model().lights, instance.number, "light");
        const auto kind = kindOf(source);
        if (!kind) {
            notes.add("Lights other than point, spot and directional ones are left out.");
            continue;
        }
        PunctualLight light = lightAt(source, instance.toWorld);
        light.kind = *kind;
        if (isUsable(light))
            result.push_back(light);
        else
            notes.add("Lights whose place, direction or intensity is no number are left out.");
    }
    return result;
}

} // namespace wellstrat::render
