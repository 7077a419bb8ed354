// SPDX-License-Identifier: Apache-2.0
//
// Draws batches when it is asked to, so that another program can measure in turn with it:
// bindings/wasm/bench. Of each line `GENERATOR DIMS ROUNDS` on its input it draws so many rounds of
// the samples of coherent contexts, on SSE4, and prints the nanoseconds of one sample.

#include "contexts.h"
#include "wellstrat/batch.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/blue.h"

#include <chrono>
#include <iostream>
#include <string>
#include <vector>

namespace wellstrat {
namespace {

constexpr std::size_t kPoints = 4096;

std::vector<SampleCtx> pixels(bool isBlue) {
    if (!isBlue) return makeContexts(kPoints, Access::coherent);
    std::vector<SampleCtx> contexts;
    for (int i = 0; i < static_cast<int>(kPoints); ++i) {
        contexts.push_back(blueContext(i % 64, i / 64, 1, 0));
    }
    return contexts;
}

using Draw = void (*)(const SampleCtx* contexts, float* xis);

template <auto kDraw, typename Sample>
void drawAll(const SampleCtx* contexts, float* xis) {
    kDraw(kPoints, contexts, Order{}, reinterpret_cast<Sample*>(xis));
}

constexpr Draw kDraws[][3] = {
    {drawAll<drawJointSamples1D, float>, drawAll<drawJointSamples2D, Float2>,
     drawAll<drawJointSamples3D, Float3>},
    {drawAll<drawSequenceSamples1D, float>, drawAll<drawSequenceSamples2D, Float2>,
     drawAll<drawSequenceSamples3D, Float3>},
    {drawAll<drawBlueSamples1D, float>, drawAll<drawBlueSamples2D, Float2>,
     drawAll<drawBlueSamples3D, Float3>}};
const std::string kNames[] = {"pmj", "long", "blue"};

double nanoseconds(Draw draw, bool isBlue, unsigned rounds) {
    const std::vector<SampleCtx> contexts = pixels(isBlue);
    std::vector<float> xis(3 * kPoints);
    draw(contexts.data(), xis.data());
    const auto start = std::chrono::steady_clock::now();
    for (unsigned i = 0; i < rounds; ++i) draw(contexts.data(), xis.data());
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    return time.count() / (rounds * static_cast<double>(kPoints));
}

} // namespace
} // namespace wellstrat

int main() {
    using namespace wellstrat;
    if (!forceBatchTarget("SSE4")) {
        std::cerr << "batch_rounds: this processor has no SSE4\n";
        return 2;
    }
    std::string name;
    unsigned dims, rounds;
    while (std::cin >> name >> dims >> rounds) {
        for (unsigned i = 0; i < 3; ++i) {
            if (name != kNames[i]) continue;
            std::cout << nanoseconds(kDraws[i][dims - 1], name == "blue", rounds) << std::endl;
        }
    }
}
