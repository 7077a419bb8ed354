// SPDX-License-Identifier: Apache-2.0
//
// Prints the data of the pictures in docs/images, which scripts/docs-pictures plots:
//
//     docs_pictures split     camera rays with reflections, without and with splitting
//     docs_pictures remap     samples that choose between two lights and are then used again

#include <RixRNG.h>
#include <RixShadingUtils.h>
#include <wellstrat/camera.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace {

constexpr RixRNG::Scramble kBxdfScramble{0x6b8f21d3};
/// A pixel whose 8 directions are easy to tell apart in a picture.
constexpr int kPixel = 234;

/// Prints one reflection: panel, number, where the camera ray hits in [0, 1), and the direction.
void printReflection(unsigned panel, unsigned number, float hit, float xi) {
    const float angle = F_PI * (0.04f + 0.92f * xi); // from the surface, a little off it
    std::printf("%u %u %.6f %.6f %.6f\n", panel, number, hit, std::cos(angle), std::sin(angle));
}

/// Left panel (0): 8 camera rays with one reflection each. Right panel (1): 2 with 4 each.
void printSplit() {
    for (unsigned panel = 0; panel < 2; ++panel) {
        const unsigned branches = panel == 0 ? 1 : 4;
        for (unsigned ray = 0; ray < 8 / branches; ++ray) {
            RixRNG::SampleCtx camera = wellstrat::cameraContext(kPixel, 0, 0, ray);
            RixRNG::SampleCtx filter = camera.NewDomain(wellstrat::kPixelFilterScramble);
            RixRNG::SampleCtx bxdf = camera.NewDomainSplit(kBxdfScramble, branches);
            const float hit = RixRNG(&filter, 1).DrawSample1D(0);
            RixRNG rng(&bxdf, 1);
            for (unsigned i = 0; i < branches; ++i) {
                printReflection(panel, ray * branches + i, hit, rng.GenerateSample1D(0));
            }
        }
    }
}

/// 256 samples: x and y as drawn, the light that x chose, and x remapped.
void printRemap() {
    RixRNG::SampleCtx context = wellstrat::cameraContext(kPixel, 0, 0, 0);
    RixRNG rng(&context, 1);
    for (unsigned i = 0; i < 256; ++i) {
        const RtFloat2 xi = rng.GenerateSample2D(0);
        float remapped = xi.x;
        const unsigned light = RixChooseAndRemap(remapped, 0.8f);
        std::printf("%.6f %.6f %u %.6f\n", xi.x, xi.y, light, remapped);
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::string picture = argc == 2 ? argv[1] : "";
    if (picture == "split") {
        printSplit();
    } else if (picture == "remap") {
        printRemap();
    } else {
        std::fputs("docs_pictures: expects one argument, split or remap\n", stderr);
        return 2;
    }
}
