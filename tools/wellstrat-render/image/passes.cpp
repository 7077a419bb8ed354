// SPDX-License-Identifier: Apache-2.0

#include "passes.h"

#include "common/command_line/interrupt.h"
#include "common/command_line/progress.h"

#include "renderer/film_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <vector>

namespace wellstrat::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPassSeconds = 2;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Work that this process has, and how far it is.
class Work {
public:
    Work(const render::Renderer& renderer, const RenderPlan& plan, const Ranks& ranks,
         render::Film& film)
        : renderer_(renderer), plan_(plan), ranks_(ranks), film_(film),
          samples_(plan.endSample - plan.firstSample), done_(film.pixels().size()) {
        leaveToOthers();
        findWork();
    }

    bool finished() const { return level_ == samples_; }
    /// Samples that each pixel has at least, unless it is good enough already.
    uint32_t level() const { return level_; }
    /// The share that is done.
    double share() const { return doneSamples_ / allSamples_; }

    /// Renders one pass; calls tileDone(share).
    template <typename TileDone>
    void pass(const std::atomic<bool>& stop, TileDone tileDone) {
        const Clock::time_point start = Clock::now();
        const uint32_t end = nextLevel();
        std::atomic<uint64_t> taken{0};
        renderer_.render({0, film_.height(), plan_.firstSample, plan_.firstSample + end, &done_},
                         film_, stop, [&](uint64_t samples) {
                             const uint64_t all = taken += samples;
                             tileDone((doneSamples_ + static_cast<double>(all)) / allSamples_);
                         });
        const double perSample = secondsSince(start) / (end - level_);
        mostSamples_ =
            static_cast<uint32_t>(std::clamp(kPassSeconds / std::max(perSample, 1e-9), 1.0, 1e9));
        findWork();
    }

private:
    /// Tiles of other ranks count as done here, and are black.
    void leaveToOthers() {
        if (ranks_.size() == 1) return;
        const unsigned tiles = (film_.width() + render::kTileSize - 1) / render::kTileSize;
        for (unsigned y = 0; y < film_.height(); ++y) {
            for (unsigned x = 0; x < film_.width(); ++x) {
                const unsigned tile = y / render::kTileSize * tiles + x / render::kTileSize;
                if (tile % ranks_.size() == ranks_.rank()) continue;
                done_[index(x, y)] = 1;
                film_.pixel(x, y) = {};
            }
        }
        others_ = done_;
    }

    /// Finds the pixels that are done, and the least number of samples among the others.
    void findWork() {
        if (plan_.noise) render::markDonePixels(film_, *plan_.noise, done_);
        level_ = samples_;
        doneSamples_ = allSamples_ = 0;
        for (std::size_t i = 0; i < done_.size(); ++i) {
            const uint32_t count = film_.pixels()[i].count;
            if (others_.empty() || others_[i] == 0) {
                doneSamples_ += done_[i] != 0 ? samples_ : count;
                allSamples_ += samples_;
            }
            if (done_[i] == 0) level_ = std::min(level_, count);
        }
        allSamples_ = std::max(allSamples_, 1.0);
    }

    /// All powers of two are among the levels, as markDonePixels needs.
    uint32_t nextLevel() const {
        uint64_t power = 1;
        while (power <= level_) power *= 2;
        const uint64_t most = uint64_t{level_} + mostSamples_;
        return static_cast<uint32_t>(std::min({power, most, uint64_t{samples_}}));
    }

    std::size_t index(unsigned x, unsigned y) const { return std::size_t{y} * film_.width() + x; }

    const render::Renderer& renderer_;
    const RenderPlan& plan_;
    const Ranks& ranks_;
    render::Film& film_;
    uint32_t samples_;
    std::vector<uint8_t> done_, others_; ///< pixels not to render; those of other ranks
    uint32_t level_ = 0;
    uint32_t mostSamples_ = std::numeric_limits<uint32_t>::max(); ///< in a pass
    double doneSamples_ = 0, allSamples_ = 0;
};

/// All of the film on rank 0; nothing new on the others.
render::Film gathered(const Ranks& ranks, const render::Film& film) {
    render::Film all = film;
    ranks.joinAtRoot(all.pixels().data(), all.pixels().size() * sizeof(render::PixelSums));
    return all;
}

} // namespace

RenderEnd runRender(const render::Renderer& renderer, const RenderPlan& plan, const Ranks& ranks,
                    render::Film& film, std::optional<double> savePeriod,
                    const std::function<void(const render::Film&)>& save) {
    const InterruptGuard guard;
    const Clock::time_point start = Clock::now();
    Clock::time_point lastSaved = start;
    Work work(renderer, plan, ranks, film);
    ProgressBar progress(plan.label, work.share());
    std::atomic<bool> stop{false};
    while (ranks.any(!work.finished()) && !ranks.any(stop)) {
        if (savePeriod && ranks.fromRoot(secondsSince(lastSaved) >= *savePeriod ? 1 : 0) != 0) {
            const render::Film all = gathered(ranks, film);
            if (ranks.isRoot()) save(all);
            lastSaved = Clock::now();
        }
        if (work.finished()) continue;
        work.pass(stop, [&](double share) {
            if (ranks.isRoot()) {
                progress.show(share, fmt::format(", {} samples", work.level()));
            }
            const bool timeIsUp = plan.timeLimit && secondsSince(start) >= *plan.timeLimit;
            if (InterruptGuard::interrupted || timeIsUp) stop = true;
        });
    }
    const bool stopped = ranks.any(!work.finished());
    const bool interrupted = ranks.any(InterruptGuard::interrupted);
    if (ranks.size() > 1) film = gathered(ranks, film);
    return !stopped      ? RenderEnd::finished
           : interrupted ? RenderEnd::interrupted
                         : RenderEnd::timeIsUp;
}

} // namespace wellstrat::cli
