// SPDX-License-Identifier: Apache-2.0

#include "integrator.h"

#include "estimates.h"
#include "wellstrat/camera.h"

#include <atomic>
#include <cmath>
#include <thread>

namespace area_light {

namespace {

using Contexts = std::vector<RixRNG::SampleCtx>;

/// The camera rays of a batch that have hit something.
struct HitBatch {
    std::vector<Hit> hits;
    std::vector<unsigned> pixel; ///< of the row, for each hit
    Contexts contexts;           ///< those of the camera rays
};

/// Memory that the batches of one thread use again and again.
struct Workspace {
    explicit Workspace(unsigned size) : camera(size), filter(size), xi(size), sum(size) {}

    Contexts camera, filter, bxdf, light;
    std::vector<RtFloat2> xi;
    std::vector<RtFloat3> sum; ///< for each pixel of the row
    HitBatch batch;
};

/// One camera ray for each pixel of the row, sample `sampleid` of each.
void traceCamera(const RenderSettings& settings, unsigned y, unsigned sampleid, Workspace& work) {
    const unsigned size = settings.size;
    for (unsigned x = 0; x < size; ++x) {
        work.camera[x] = wellstrat::cameraContext(static_cast<int>(x), static_cast<int>(y),
                                                  settings.frame, sampleid);
    }
    const RixRNG camera(work.camera.data(), size, settings.generator);
    const RixRNG filter(camera, wellstrat::kPixelFilterScramble, work.filter.data());
    filter.DrawSamples2D(work.xi.data());

    HitBatch& batch = work.batch;
    batch.hits.clear();
    batch.pixel.clear();
    batch.contexts.clear();
    for (unsigned x = 0; x < size; ++x) {
        const RtFloat2 image =
            (RtFloat2(static_cast<float>(x), static_cast<float>(y)) + work.xi[x]) *
            (1.0f / static_cast<float>(size));
        Hit hit;
        if (!intersect(cameraRay(image), hit)) continue;
        batch.hits.push_back(hit);
        batch.pixel.push_back(x);
        batch.contexts.push_back(work.camera[x]);
    }
}

/// A new domain of all points of `parent`. `contexts` receives its contexts.
RixRNG branch(const RixRNG& parent, RixRNG::Scramble scramble, Branching branching,
              Contexts& contexts) {
    contexts.resize(parent.numPts);
    switch (branching) {
    case Branching::split: return {parent, scramble, contexts.data(), RixRNG::Split{kBranches}};
    case Branching::distribution: return {parent, scramble, contexts.data(), RixRNG::Distrib{0}};
    default: return {parent, scramble, contexts.data()};
    }
}

/// Adds an estimate of light at each hit to its pixel, one that takes a 2D sample of `rng`, and
/// steps to the next sample.
template <class Estimate>
void accumulate(RixRNG& rng, Workspace& work, const Estimate& estimate) {
    rng.GenerateSamples2D(work.xi.data());
    for (unsigned i = 0; i < rng.numPts; ++i) {
        const Hit& hit = work.batch.hits[i];
        work.sum[work.batch.pixel[i]] += hit.albedo * estimate(hit, work.xi[i]);
    }
}

/// Every shading batch is one camera ray for each pixel of a row.
void renderRow(const RenderSettings& settings, unsigned y, Workspace& work, RtFloat3* row) {
    work.sum.assign(settings.size, RtFloat3(0.0f));
    const unsigned branches = branchCount(settings.branching);
    const unsigned cameraRays = settings.samplesPerPixel / branches;
    for (unsigned sampleid = 0; sampleid < cameraRays; ++sampleid) {
        traceCamera(settings, y, sampleid, work);
        Contexts& contexts = work.batch.contexts;
        const RixRNG hits(contexts.data(), static_cast<unsigned>(contexts.size()),
                          settings.generator);
        RixRNG bxdf = branch(hits, kBxdfScramble, settings.branching, work.bxdf);
        RixRNG light = branch(hits, kLightScramble, settings.branching, work.light);
        for (unsigned i = 0; i < branches; ++i) {
            accumulate(light, work, lightEstimate);
            accumulate(bxdf, work, skyEstimate);
        }
    }
    const float weight = 1.0f / static_cast<float>(cameraRays * branches);
    for (unsigned x = 0; x < settings.size; ++x) row[x] = work.sum[x] * weight;
}

} // namespace

Image render(const RenderSettings& settings) {
    Image image(std::size_t{settings.size} * settings.size);
    std::atomic<unsigned> nextRow{0};
    const auto renderRows = [&] {
        Workspace work(settings.size);
        for (unsigned y; (y = nextRow++) < settings.size;) {
            renderRow(settings, y, work, &image[std::size_t{y} * settings.size]);
        }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < settings.threads; ++i) others.emplace_back(renderRows);
    renderRows();
    for (std::thread& thread : others) thread.join();
    return image;
}

double rmse(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const RtFloat3 difference = a[i] - b[i];
        sum += static_cast<double>(difference.LengthSq());
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.size())));
}

} // namespace area_light
