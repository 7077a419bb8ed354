// SPDX-License-Identifier: Apache-2.0
//
// The function of a pixel gives the picture of the CPU's integrator, bit for bit.

#include "../area_light/integrator.h"
#include "pixel.h"

#include <cstdio>

int main() {
    constexpr unsigned kSize = 64, kSamples = 4;
    const area_light::Image image =
        area_light::render({kSize, kSamples, area_light::Branching::plain, nullptr, 0, 1});
    for (unsigned y = 0; y < kSize; ++y) {
        for (unsigned x = 0; x < kSize; ++x) {
            const RtFloat3 pixel =
                area_light::renderPixel(wellstrat::tables(), kSize, x, y, kSamples);
            if (pixel == image[y * kSize + x]) continue;
            std::printf("pixel (%u, %u) differs\n", x, y);
            return 1;
        }
    }
    return 0;
}
