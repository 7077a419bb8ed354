// SPDX-License-Identifier: Apache-2.0

#include "run.h"

#include "passes.h"
#include "sampling.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace wellstrat::cli {

ImageRun::ImageRun(SceneOptions options, uint64_t seed, const render::Scene& scene, ImageSize size,
                   const Generator* generator, const Ranks& ranks, std::string label)
    : ranks_(ranks), label_(std::move(label)), film_(size.width, size.height) {
    options.seed = seed;
    renderer_ = makeRenderer(options, scene, size, generator);
}

bool ImageRun::render(uint32_t samples) {
    const auto start = std::chrono::steady_clock::now();
    const RenderPlan plan{0, samples, {}, {}, fmt::format("{}, {} samples", label_, samples)};
    const RenderEnd end = runRender(*renderer_, plan, ranks_, film_, {}, {});
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return end == RenderEnd::finished;
}

} // namespace wellstrat::cli
