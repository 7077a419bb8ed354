// SPDX-License-Identifier: Apache-2.0
//
// Renders a scene onto a film: tiles over threads, passes of samples, and when to stop. What a
// sample is worth is in integrator.h.

#pragma once

#include "film.h"
#include "sampling_options.h"
#include "scene.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace wellstrat::render {

/// Renders width x height pixels of `scene`. All functions but setCamera may run in any thread.
class Renderer {
public:
    /// Builds what rays need. The scene must outlive this and have a camera. Throws
    /// std::invalid_argument, which says what was wrong.
    Renderer(const Scene& scene, unsigned width, unsigned height, const SamplingOptions& options);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    unsigned width() const;
    unsigned height() const;

    /// Renders from `camera` from now on, as if the scene had it, for the next picture of a
    /// sequence: what rays need is not built anew. Not while another function runs. Throws
    /// std::invalid_argument.
    void setCamera(const Camera& camera);

    /// The samples of one pass. Pixel (x, y) takes those from firstSample + film.pixel(x, y).count
    /// up to endSample (exclusive): a film that was interrupted goes on where it stopped.
    struct Pass {
        unsigned firstRow, endRow; ///< the rows of pixels to render
        unsigned firstSample;      ///< of the film as a whole
        unsigned endSample;
        /// Pixels to leave out, row by row, or null: for those that are good enough already.
        const std::vector<uint8_t>* done = nullptr;
    };

    /// Adds the samples of a pass to `film`, with all threads of the current TBB arena. A pixel of
    /// the result depends on nothing but the scene, the options and its own samples. Stops between
    /// tiles when `stop` becomes true: each pixel of the film has then all or none of its samples.
    /// Calls `tileDone` with the number of camera samples taken, from any thread.
    void render(const Pass& pass, Film& film, const std::atomic<bool>& stop,
                const std::function<void(uint64_t samples)>& tileDone) const;

    /// Path segments (camera and bounce rays; no shadow rays) traced so far.
    uint64_t segments() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wellstrat::render
