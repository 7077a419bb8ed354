// SPDX-License-Identifier: Apache-2.0
//
// From Assimp's lights and cameras to ours.

#include "lights_and_cameras.h"
#include "../framing.h"
#include "conversions.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace wellstrat::render {
namespace {

/// Where the node of this name puts things. Assimp names the node of a light or camera like it.
aiMatrix4x4 toWorldOf(const aiScene& scene, const aiString& name) {
    aiMatrix4x4 toWorld;
    for (const aiNode* node = scene.mRootNode->FindNode(name); node; node = node->mParent)
        toWorld = node->mTransformation * toWorld;
    return toWorld;
}

Float3 toUnitLength(Float3 v) {
    v.Normalize();
    return v;
}

std::optional<PunctualLight::Kind> kindOf(const aiLight& light) {
    switch (light.mType) {
    case aiLightSource_POINT: return PunctualLight::Kind::point;
    case aiLightSource_SPOT: return PunctualLight::Kind::spot;
    case aiLightSource_DIRECTIONAL: return PunctualLight::Kind::directional;
    default: return {};
    }
}

bool isUsable(const PunctualLight& light) {
    const bool hasDirection = std::abs(light.direction.LengthSq() - 1) < 1e-3f;
    return isFinite(light.position) && isFinite(light.intensity) &&
           (light.kind == PunctualLight::Kind::point || hasDirection) &&
           std::isfinite(light.cosInner) && std::isfinite(light.cosOuter) &&
           light.intensity.x >= 0 && light.intensity.y >= 0 && light.intensity.z >= 0;
}

PunctualLight importLight(const aiLight& light, PunctualLight::Kind kind,
                          const aiMatrix4x4& toWorld) {
    PunctualLight result{};
    result.kind = kind;
    result.position = toFloat3(toWorld * light.mPosition);
    if (kind != PunctualLight::Kind::point)
        result.direction = toUnitLength(toFloat3(aiMatrix3x3(toWorld) * light.mDirection));
    result.intensity = {light.mColorDiffuse.r, light.mColorDiffuse.g, light.mColorDiffuse.b};
    if (kind != PunctualLight::Kind::directional && light.mAttenuationQuadratic > 0)
        result.intensity /= light.mAttenuationQuadratic;
    if (kind == PunctualLight::Kind::spot) {
        // Assimp has the angles from side to side.
        result.cosInner = std::cos(light.mAngleInnerCone * 0.5f);
        result.cosOuter = std::min(std::cos(light.mAngleOuterCone * 0.5f), result.cosInner);
    }
    return result;
}

/// Assimp has the angle from side to side.
float verticalFov(float horizontalFov, float aspect) {
    return 2 * std::atan(std::tan(horizontalFov / 2) / aspect);
}

NamedCamera importCamera(const aiCamera& camera, const aiMatrix4x4& toWorld) {
    const float aspect = camera.mAspect > 0 && std::isfinite(camera.mAspect) ? camera.mAspect : 1;
    const aiMatrix3x3 rotation(toWorld);
    return {camera.mName.C_Str(),
            {},
            lookAlong(toFloat3(toWorld * camera.mPosition), toFloat3(rotation * camera.mLookAt),
                      toFloat3(rotation * camera.mUp), verticalFov(camera.mHorizontalFOV, aspect)),
            aspect};
}

} // namespace

std::vector<PunctualLight> importLights(const aiScene& scene, Notes& notes) {
    std::vector<PunctualLight> lights;
    for (unsigned i = 0; i < scene.mNumLights; ++i) {
        const aiLight& light = *scene.mLights[i];
        const auto kind = kindOf(light);
        if (!kind) {
            notes.add("Lights other than point, spot and directional ones are left out.");
            continue;
        }
        const PunctualLight result = importLight(light, *kind, toWorldOf(scene, light.mName));
        if (isUsable(result))
            lights.push_back(result);
        else
            notes.add("Lights whose place, direction or intensity is no number are left out.");
    }
    return lights;
}

std::vector<NamedCamera> importCameras(const aiScene& scene, Notes& notes) {
    std::vector<NamedCamera> cameras;
    for (unsigned i = 0; i < scene.mNumCameras; ++i) {
        const aiCamera& camera = *scene.mCameras[i];
        try {
            cameras.push_back(importCamera(camera, toWorldOf(scene, camera.mName)));
        } catch (const std::invalid_argument& error) {
            notes.add(std::string("A camera is left out: ") + error.what() + ".");
        }
    }
    return cameras;
}

} // namespace wellstrat::render
