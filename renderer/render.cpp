// SPDX-License-Identifier: Apache-2.0
#include "render.h"

#include "integrator.h"
#include "scene_check.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

namespace wellstrat::render {

namespace {

static_assert(kTileSize * kTileSize == kBatchSize, "a tile is a batch");

/// A pixel, and the samples that it takes.
struct PixelWork {
    unsigned x, y;
    unsigned firstSample;
};

} // namespace

struct Renderer::State {
    unsigned width, height;
    bool background;
    Integrator integrator;
    mutable std::atomic<uint64_t> segments{0};
    mutable tbb::enumerable_thread_specific<PathBatch> batches; ///< memory to work in

    State(const Scene& scene, unsigned w, unsigned h, const SamplingOptions& options)
        : width(w), height(h), background(options.background), integrator(scene, w, h, options) {}

    uint64_t renderTile(const Pass& pass, unsigned column, unsigned row, Film& film) const;
};

/// Renders the tile whose upper left pixel is (column, row). Returns the number of samples.
uint64_t Renderer::State::renderTile(const Pass& pass, unsigned column, unsigned row,
                                     Film& film) const {
    std::vector<PixelWork> pixels;
    for (unsigned y = row; y < std::min(row + kTileSize, pass.endRow); ++y) {
        for (unsigned x = column; x < std::min(column + kTileSize, width); ++x) {
            if (pass.done && (*pass.done)[std::size_t{y} * width + x]) continue;
            pixels.push_back({x, y, pass.firstSample + film.pixel(x, y).count});
        }
    }
    PathBatch& batch = batches.local();
    CameraSample samples[kBatchSize];
    Float3 results[kBatchSize];
    uint64_t taken = 0;
    for (unsigned round = 0;; ++round) {
        unsigned count = 0;
        for (const PixelWork& pixel : pixels) {
            if (pixel.firstSample >= pass.endSample) continue;
            if (round >= pass.endSample - pixel.firstSample) continue;
            samples[count++] = {pixel.x, pixel.y, pixel.firstSample + round};
        }
        if (count == 0) return taken;
        segments += integrator.radiance(count, samples, batch, results);
        for (unsigned i = 0; i < count; ++i)
            film.add(samples[i].x, samples[i].y, results[i], !background && batch.meetsNothing[i]);
        taken += count;
    }
}

Renderer::Renderer(const Scene& scene, unsigned width, unsigned height,
                   const SamplingOptions& options) {
    checkScene(scene);
    if (width < 1 || height < 1 || width > 65536 || height > 65536) {
        throw std::invalid_argument("a picture has 1 to 65536 pixels in width and in height");
    }
    if (options.split < 1) throw std::invalid_argument("there is at least 1 light sample");
    state_ = std::make_unique<State>(scene, width, height, options);
}

Renderer::~Renderer() = default;

unsigned Renderer::width() const { return state_->width; }
unsigned Renderer::height() const { return state_->height; }

void Renderer::setCamera(const Camera& camera) {
    checkCamera(camera);
    state_->integrator.setCamera({camera, state_->width, state_->height});
}

uint64_t Renderer::segments() const { return state_->segments; }

void Renderer::render(const Pass& pass, Film& film, const std::atomic<bool>& stop,
                      const std::function<void(uint64_t samples)>& tileDone) const {
    const unsigned columns = (state_->width + kTileSize - 1) / kTileSize;
    const unsigned rows = (pass.endRow - pass.firstRow + kTileSize - 1) / kTileSize;
    tbb::parallel_for(0u, columns * rows, [&](unsigned tile) {
        if (stop) return;
        tileDone(state_->renderTile(pass, tile % columns * kTileSize,
                                    pass.firstRow + tile / columns * kTileSize, film));
    });
}

} // namespace wellstrat::render
