// SPDX-License-Identifier: Apache-2.0
#include "studio.h"

#include "color.h"
#include "emission.h"
#include "integrator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace wellstrat::render {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// From 0 below `low` to 1 above `high`, smoothly.
float smoothStep(float low, float high, float x) {
    const float t = clamp01((x - low) / (high - low));
    return t * t * (3 - 2 * t);
}

/// The studio around who looks along -z. Sky and key light give about as much each.
float studioRadiance(Float3 direction) {
    constexpr float kGround = 0.18f, kHorizon = 0.4f, kZenith = 0.6f, kKey = 7;
    constexpr float kCosOfKey = 0.955f; // of its radius, 17 degrees
    Float3 toKey(-0.6f, 0.8f, 0.7f);
    toKey.Normalize();
    const float sky = kHorizon + (kZenith - kHorizon) * std::max(direction.y, 0.0f);
    const float key =
        kKey * smoothStep(kCosOfKey - 0.02f, kCosOfKey + 0.02f, Dot(direction, toKey));
    return kGround + (sky - kGround) * smoothStep(-0.2f, 0.2f, direction.y) + key;
}

bool hasLight(const Scene& scene) {
    if (scene.environment || !scene.lights.empty()) return true;
    const auto shines = [&](const auto& shape) { return emits(scene.materials[shape.material]); };
    return std::any_of(scene.meshes.begin(), scene.meshes.end(), shines) ||
           std::any_of(scene.spheres.begin(), scene.spheres.end(), shines);
}

} // namespace

Environment studio(Float3 forward) {
    constexpr unsigned kWidth = 256, kHeight = 128;
    std::vector<Float3> pixels;
    pixels.reserve(std::size_t{kWidth} * kHeight);
    for (unsigned row = 0; row < kHeight; ++row) {
        const double polar = kPi * (row + 0.5) / kHeight;
        for (unsigned column = 0; column < kWidth; ++column) {
            const double azimuth = 2 * kPi * ((column + 0.5) / kWidth - 0.5);
            const Float3 direction(static_cast<float>(std::sin(polar) * std::sin(azimuth)),
                                   static_cast<float>(std::cos(polar)),
                                   static_cast<float>(-std::sin(polar) * std::cos(azimuth)));
            pixels.emplace_back(studioRadiance(direction));
        }
    }
    Environment environment;
    environment.map = std::make_shared<const Texture>(kWidth, kHeight, std::move(pixels));
    environment.rotation = std::atan2(-forward.x, -forward.z);
    return environment;
}

double litShare(const Scene& scene, float aspect) {
    if (!hasLight(scene)) return 0;
    constexpr unsigned kRows = 32, kSamples = 16;
    const auto columns =
        static_cast<unsigned>(std::clamp(std::round(kRows * aspect), 1.0f, 8.0f * kRows));
    SamplingOptions options;
    options.depth = 2;
    const Integrator integrator(scene, columns, kRows, options);
    const auto batch = std::make_unique<PathBatch>();
    unsigned seen = 0, lit = 0;
    for (unsigned i = 0; i < columns * kRows; ++i) {
        CameraSample samples[kSamples];
        Float3 radiance[kSamples];
        for (unsigned j = 0; j < kSamples; ++j) samples[j] = {i % columns, i / columns, j};
        integrator.radiance(kSamples, samples, *batch, radiance);
        Float3 sum(0.0f);
        unsigned hits = 0;
        for (unsigned j = 0; j < kSamples; ++j) {
            sum += radiance[j];
            hits += batch->meetsNothing[j] ? 0 : 1;
        }
        seen += hits;
        if (luminance(sum) > kLitLuminance * kSamples) lit += hits;
    }
    return seen == 0 ? 1 : static_cast<double>(lit) / seen;
}

} // namespace wellstrat::render
