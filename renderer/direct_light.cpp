// SPDX-License-Identifier: Apache-2.0
#include "direct_light.h"

#include "compaction.h"
#include "emission.h"
#include "sampling_domains.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

/// The power heuristic, with power 2: the weight of a sample of density `pdf` that might as well
/// have come with density `other`.
float powerHeuristic(float pdf, float other) {
    const float ratio = other / pdf;
    return 1.0f / (1.0f + ratio * ratio);
}

/// The weight of what a path's ray found by chance. Light samples would have found it with density
/// `lightPdf` each.
float chanceWeight(Strategy strategy, const Path& path, float lightPdf) {
    if (path.lightSamples == 0 || !(lightPdf > 0.0f)) return 1.0f;
    if (strategy != Strategy::both) return strategy == Strategy::bxdf ? 1.0f : 0.0f;
    return powerHeuristic(path.bxdfPdf, static_cast<float>(path.lightSamples) * lightPdf);
}

/// The weight over the density of one of `count` samples of a light.
float sampleWeight(Strategy strategy, unsigned count, float lightPdf, float bxdfPdf) {
    if (strategy == Strategy::bxdf) return 0.0f;
    const float pdf = static_cast<float>(count) * lightPdf;
    return (strategy == Strategy::both ? powerHeuristic(pdf, bxdfPdf) : 1.0f) / pdf;
}

/// The domain from which the hits of a bounce draw light samples.
RixRNG lightDomain(const RixRNG& hits, RixRNG::Scramble scramble, const SamplingOptions& options,
                   unsigned bounce, RixRNG::SampleCtx* contexts) {
    if (bounce == 0) return {hits, scramble, contexts, RixRNG::Split{options.split}};
    if (options.distrib) return {hits, scramble, contexts, RixRNG::Distrib{0}};
    return {hits, scramble, contexts};
}

/// Calls estimate(path, xi) for as many samples of the domain `rng` as each path takes. Those that
/// have had theirs drop out, and the rest draw on.
template <class Estimate>
void forEachSample(RixRNG rng, PathBatch& batch, const Estimate& estimate) {
    unsigned numbers[kBatchSize];
    for (unsigned i = 0; i < rng.numPts; ++i) numbers[i] = i;
    for (unsigned taken = 1; rng.numPts > 0; ++taken) {
        rng.GenerateSamples2D(batch.xi);
        const auto takesAnother = [&](unsigned i) {
            estimate(numbers[i], batch.xi[i]);
            return taken < batch.paths[numbers[i]].lightSamples;
        };
        rng.numPts = compact(rng.numPts, takesAnother, numbers, rng.sampleCtxArray);
    }
}

} // namespace

DirectLight::DirectLight(const Scene& scene, const Geometry& geometry,
                         const SamplingOptions& options)
    : geometry_(geometry), options_(options), lights_(scene) {
    if (scene.environment) environment_.emplace(*scene.environment);
}

unsigned DirectLight::sampleCount(unsigned bounce, const Path& path) const {
    if (bounce == 0) return options_.split;
    if (!options_.distrib) return 1;
    const float worth = clamp01(largestChannel(path.throughput));
    return std::max(1u,
                    static_cast<unsigned>(std::ceil(static_cast<float>(options_.split) * worth)));
}

void DirectLight::sample(const RixRNG& hits, unsigned bounce, PathBatch& batch,
                         Float3* results) const {
    for (unsigned i = 0; i < hits.numPts; ++i) {
        batch.paths[i].lightSamples = sampleCount(bounce, batch.paths[i]);
    }
    if (!lights_.empty()) {
        forEachSample(lightDomain(hits, lightScramble(bounce), options_, bounce, batch.domain),
                      batch, [&](unsigned i, Float2 xi) {
                          const Path& path = batch.paths[i];
                          results[path.point] += lightSample(path, batch.vertices[i], xi);
                      });
    }
    if (environment_ && environment_->canSample()) {
        forEachSample(
            lightDomain(hits, environmentScramble(bounce), options_, bounce, batch.domain), batch,
            [&](unsigned i, Float2 xi) {
                const Path& path = batch.paths[i];
                results[path.point] += environmentSample(path, batch.vertices[i], xi);
            });
    }
}

Float3 DirectLight::lightSample(const Path& path, const Vertex& vertex, Float2 xi) const {
    LightSample light;
    if (!lights_.sample(vertex.point, path.ray.time, xi, light)) return Float3(0.0f);
    const BxdfValue bxdf = vertex.bxdf.evaluate(light.direction);
    if (isBlack(bxdf.value)) return Float3(0.0f);
    const float passing = geometry_.transmittance(light.shadowRay);
    if (passing == 0.0f) return Float3(0.0f);
    const float weight =
        light.punctual ? 1.0f / (static_cast<float>(path.lightSamples) * light.pdf)
                       : sampleWeight(options_.strategy, path.lightSamples, light.pdf, bxdf.pdf);
    if (const MediumPtr medium = mediumTowards(light.direction, path, vertex))
        light.radiance =
            multiply(light.radiance, transmittance(*medium, light.shadowRay.maxDistance));
    return multiply(multiply(path.throughput, bxdf.value), light.radiance) * (weight * passing);
}

Float3 DirectLight::environmentSample(const Path& path, const Vertex& vertex, Float2 xi) const {
    float pdf;
    const Float3 direction = environment_->sample(xi, pdf);
    const BxdfValue bxdf = vertex.bxdf.evaluate(direction);
    if (isBlack(bxdf.value)) return Float3(0.0f);
    const float passing = geometry_.transmittance(leave(vertex.point, direction, path.ray.time));
    if (passing == 0.0f) return Float3(0.0f);
    const float weight = sampleWeight(options_.strategy, path.lightSamples, pdf, bxdf.pdf);
    return multiply(multiply(path.throughput, bxdf.value), environment_->radiance(direction)) *
           (weight * passing);
}

Float3 DirectLight::fromSurface(const Path& path, const Hit& hit, const Surface& surface) const {
    if (!emits(*surface.material)) return Float3(0.0f);
    const Float3 radiance = emittedRadiance(*surface.material, surface.attributes,
                                            surface.point.normal, -path.ray.direction);
    if (isBlack(radiance)) return radiance;
    const float pdf = lights_.pdf(path.ray, hit, surface);
    return multiply(path.throughput, radiance) * chanceWeight(options_.strategy, path, pdf);
}

Float3 DirectLight::fromEnvironment(const Path& path) const {
    if (!environment_) return Float3(0.0f);
    const float pdf = environment_->pdf(path.ray.direction);
    return multiply(path.throughput, environment_->radiance(path.ray.direction)) *
           chanceWeight(options_.strategy, path, pdf);
}

} // namespace wellstrat::render
