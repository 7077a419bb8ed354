// SPDX-License-Identifier: Apache-2.0
#include <RixRNG.h>
#include <wellstrat/camera.h>

#include <cstdio>

int main() {
    RixRNG::SampleCtx contexts[4], lightContexts[4];
    for (unsigned i = 0; i < 4; ++i) // four samples of pixel (320, 200) in frame 1
        contexts[i] = wellstrat::cameraContext(320, 200, 1, i);

    RixRNG pixel(contexts, 4);
    RixRNG light(pixel, RixRNG::Scramble{0x5d1c9a37}, lightContexts); // an independent domain

    RtFloat2 xi[4], onLight[4];
    pixel.DrawSamples2D(xi);
    light.DrawSamples2D(onLight);
    for (unsigned i = 0; i < 4; ++i)
        std::printf("sample %u: pixel (%.3f, %.3f)  light (%.3f, %.3f)\n", i, xi[i].x, xi[i].y,
                    onLight[i].x, onLight[i].y);
}
