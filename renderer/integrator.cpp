// SPDX-License-Identifier: Apache-2.0
#include "integrator.h"

#include "color.h"
#include "compaction.h"
#include "sampling_domains.h"

#include <RixShadingUtils.h>
#include <wellstrat/camera.h>

#include <algorithm>

namespace wellstrat::render {

namespace {

/// All pictures of a sequence, whose frames differ in their sampleids: together they are
/// stratified.
constexpr unsigned kFrame = 0;

/// From this bounce on, paths may end by Russian roulette.
constexpr unsigned kRouletteBounce = 2;

/// Even paths that lose nothing end at some time.
constexpr float kLargestSurvival = 0.95f;

/// Russian roulette (Arvo and Kirk 1990, "Particle Transport and Image Synthesis"): returns false
/// if the path ends, and makes up for those that did. Unstratified: whether paths end has nothing
/// to gain from strata, and it must not use up anyone else's.
bool survives(RixRNG::SampleCtx roulette, Float3& throughput) {
    const float survival = std::min(largestChannel(throughput), kLargestSurvival);
    if (!(HashToRandom(roulette.patternid, roulette.sampleid) < survival)) return false;
    throughput /= survival;
    return true;
}

/// By what a ray passes surfaces that are not all there. Unstratified, as survival is.
uint32_t chanceOf(RixRNG::SampleCtx passage) {
    return static_cast<uint32_t>(HashToRandom(passage.patternid, passage.sampleid) * 0x1p24f);
}

} // namespace

Integrator::Integrator(const Scene& scene, unsigned width, unsigned height,
                       const SamplingOptions& options)
    : options_(options), camera_(*scene.camera, width, height), geometry_(scene),
      directLight_(scene, geometry_, options), materials_(scene.materials.data()) {
    for (const Material& material : scene.materials)
        uniform_.push_back(isTextured(material) ? BxdfParameters{} : bxdfParameters(material, {}));
}

uint64_t Integrator::radiance(unsigned count, const CameraSample* samples, PathBatch& batch,
                              Float3* results) const {
    std::fill_n(results, count, Float3(0.0f));
    for (unsigned i = 0; i < count; ++i) {
        const CameraSample& s = samples[i];
        batch.meetsNothing[i] = false;
        const int x = static_cast<int>(s.x), y = static_cast<int>(s.y);
        batch.contexts[i] = options_.generator
                                ? options_.generator->CameraContext(x, y, options_.seed, s.sampleid)
                                : cameraContext(x, y, kFrame, s.sampleid, options_.seed);
    }
    RixRNG rng(batch.contexts, count, options_.generator);
    startPaths(rng, samples, batch);

    uint64_t rays = 0;
    for (unsigned bounce = 0; rng.numPts > 0; ++bounce) {
        rays += rng.numPts;
        rng.numPts = findHits(rng.numPts, bounce, batch, results);
        rng = RixRNG(rng, kHitScramble, batch.contexts); // each hit's domain, from the last one's
        directLight_.sample(rng, bounce, batch, results);
        rng.numPts = scatter(rng, bounce, batch);
    }
    return rays;
}

/// Makes the camera rays.
void Integrator::startPaths(const RixRNG& camera, const CameraSample* samples,
                            PathBatch& batch) const {
    RtFloat2 inPicture[kBatchSize];
    RtFloat2 onLens[kBatchSize];
    float times[kBatchSize];
    RixRNG(camera, kPixelFilterScramble, batch.domain).DrawSamples2D(inPicture);
    RixRNG(camera, kLensScramble, batch.domain).DrawSamples2D(onLens);
    RixRNG(camera, kTimeScramble, batch.domain).DrawSamples1D(times);
    for (unsigned i = 0; i < camera.numPts; ++i) {
        const Float2 center(static_cast<float>(samples[i].x) + 0.5f,
                            static_cast<float>(samples[i].y) + 0.5f);
        const Float2 position = center + filter_.offset(inPicture[i]);
        batch.paths[i] = Path{i, camera_.ray(position, onLens[i], times[i])};
        if (geometry_.isBlended())
            batch.paths[i].ray.chance = chanceOf(camera.NewDomain(i, kPassageScramble));
    }
}

/// Follows all rays to what they meet, and adds the light that comes from there. Returns how many
/// paths go on from there.
unsigned Integrator::findHits(unsigned count, unsigned bounce, PathBatch& batch,
                              Float3* results) const {
    const auto goesOn = [&](unsigned i) {
        Path& path = batch.paths[i];
        Hit hit;
        if (!geometry_.closestHit(path.ray, hit)) {
            batch.meetsNothing[path.point] = bounce == 0;
            if (bounce > 0 || options_.background)
                results[path.point] += directLight_.fromEnvironment(path);
            return false;
        }
        const Surface surface = geometry_.surface(path.ray, hit);
        if (path.medium)
            path.throughput = multiply(path.throughput, transmittance(*path.medium, hit.distance));
        results[path.point] += directLight_.fromSurface(path, hit, surface);
        if (bounce > options_.depth) return false;
        batch.vertices[i] = vertexAt(path, surface);
        return true;
    };
    return compact(count, goesOn, batch.paths, batch.vertices, batch.contexts);
}

/// Where the path's ray ends.
Vertex Integrator::vertexAt(const Path& path, const Surface& surface) const {
    const Float3 view = -path.ray.direction;
    const auto vertex = [&](const BxdfParameters& parameters) -> Vertex {
        MediumPtr behind = path.medium;
        if (parameters.isSolid)
            behind = mediumBehind(*surface.material, Dot(view, surface.point.normal) > 0.0f);
        return {surface.point, Bxdf(parameters, surface.point.normal, surface.shadingNormal, view),
                behind};
    };
    if (!surface.isUniform) return vertex(bxdfParameters(*surface.material, surface.attributes));
    return vertex(uniform_[static_cast<std::size_t>(surface.material - materials_)]);
}

/// Sends all paths on in a direction of their bxdf. Returns how many are left.
unsigned Integrator::scatter(const RixRNG& hits, unsigned bounce, PathBatch& batch) const {
    RixRNG(hits, bxdfScramble(bounce), batch.domain).DrawSamples2D(batch.xi);
    const auto goesOn = [&](unsigned i) {
        Path& path = batch.paths[i];
        BxdfSample bxdf;
        if (!batch.vertices[i].bxdf.sample(batch.xi[i], bxdf)) return false;
        path.throughput = multiply(path.throughput, bxdf.weight);
        if (bounce >= kRouletteBounce &&
            !survives(hits.NewDomain(i, kRouletteScramble), path.throughput)) {
            return false;
        }
        path.bxdfPdf = bxdf.pdf;
        path.medium = mediumTowards(bxdf.direction, path, batch.vertices[i]);
        path.ray = leave(batch.vertices[i].point, bxdf.direction, path.ray.time);
        if (geometry_.isBlended()) path.ray.chance = chanceOf(hits.NewDomain(i, kPassageScramble));
        return true;
    };
    return compact(hits.numPts, goesOn, batch.paths, batch.contexts);
}

} // namespace wellstrat::render
