// SPDX-License-Identifier: Apache-2.0
//
// The colors of the Cornell box, from its measured spectra.

#include "cornell_colors.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace wellstrat::render {
namespace {

constexpr std::size_t kWavelengths = 76; ///< 400, 404, ..., 700 nm
using Spectrum = std::array<float, kWavelengths>;

constexpr double wavelength(std::size_t i) { return 400.0 + 4.0 * static_cast<double>(i); }

// Reflectances: Cornell University Program of Computer Graphics, "Cornell Box Data", 2005,
// https://www.graphics.cornell.edu/online/box/data.html, section 2.
constexpr Spectrum kWhite{
    0.343f, 0.445f, 0.551f, 0.624f, 0.665f, 0.687f, 0.708f, 0.723f, 0.715f, 0.710f, 0.745f,
    0.758f, 0.739f, 0.767f, 0.777f, 0.765f, 0.751f, 0.745f, 0.748f, 0.729f, 0.745f, 0.757f,
    0.753f, 0.750f, 0.746f, 0.747f, 0.735f, 0.732f, 0.739f, 0.734f, 0.725f, 0.721f, 0.733f,
    0.725f, 0.732f, 0.743f, 0.744f, 0.748f, 0.728f, 0.716f, 0.733f, 0.726f, 0.713f, 0.740f,
    0.754f, 0.764f, 0.752f, 0.736f, 0.734f, 0.741f, 0.740f, 0.732f, 0.745f, 0.755f, 0.751f,
    0.744f, 0.731f, 0.733f, 0.744f, 0.731f, 0.712f, 0.708f, 0.729f, 0.730f, 0.727f, 0.707f,
    0.703f, 0.729f, 0.750f, 0.760f, 0.751f, 0.739f, 0.724f, 0.730f, 0.740f, 0.737f};

constexpr Spectrum kRed{
    0.040f, 0.046f, 0.048f, 0.053f, 0.049f, 0.050f, 0.053f, 0.055f, 0.057f, 0.056f, 0.059f,
    0.057f, 0.061f, 0.061f, 0.060f, 0.062f, 0.062f, 0.062f, 0.061f, 0.062f, 0.060f, 0.059f,
    0.057f, 0.058f, 0.058f, 0.058f, 0.056f, 0.055f, 0.056f, 0.059f, 0.057f, 0.055f, 0.059f,
    0.059f, 0.058f, 0.059f, 0.061f, 0.061f, 0.063f, 0.063f, 0.067f, 0.068f, 0.072f, 0.080f,
    0.090f, 0.099f, 0.124f, 0.154f, 0.192f, 0.255f, 0.287f, 0.349f, 0.402f, 0.443f, 0.487f,
    0.513f, 0.558f, 0.584f, 0.620f, 0.606f, 0.609f, 0.651f, 0.612f, 0.610f, 0.650f, 0.638f,
    0.627f, 0.620f, 0.630f, 0.628f, 0.642f, 0.639f, 0.657f, 0.639f, 0.635f, 0.642f};

constexpr Spectrum kGreen{
    0.092f, 0.096f, 0.098f, 0.097f, 0.098f, 0.095f, 0.095f, 0.097f, 0.095f, 0.094f, 0.097f,
    0.098f, 0.096f, 0.101f, 0.103f, 0.104f, 0.107f, 0.109f, 0.112f, 0.115f, 0.125f, 0.140f,
    0.160f, 0.187f, 0.229f, 0.285f, 0.343f, 0.390f, 0.435f, 0.464f, 0.472f, 0.476f, 0.481f,
    0.462f, 0.447f, 0.441f, 0.426f, 0.406f, 0.373f, 0.347f, 0.337f, 0.314f, 0.285f, 0.277f,
    0.266f, 0.250f, 0.230f, 0.207f, 0.186f, 0.171f, 0.160f, 0.148f, 0.141f, 0.136f, 0.130f,
    0.126f, 0.123f, 0.121f, 0.122f, 0.119f, 0.114f, 0.115f, 0.117f, 0.117f, 0.118f, 0.120f,
    0.122f, 0.128f, 0.132f, 0.139f, 0.144f, 0.146f, 0.150f, 0.152f, 0.157f, 0.159f};

// The light's emission at 400, 500, 600 and 700 nm: the same page, section 3.
constexpr double kLight[] = {0.0, 8.0, 15.6, 18.4};

double lightAt(double nm) {
    const auto below = nm < 500 ? 0 : nm < 600 ? 1 : 2;
    const double t = (nm - 400) / 100 - below;
    return kLight[below] * (1 - t) + kLight[below + 1] * t;
}

/// A bell of different widths on its two sides.
double lobe(double nm, double height, double middle, double widthBelow, double widthAbove) {
    const double t = (nm - middle) / (nm < middle ? widthBelow : widthAbove);
    return height * std::exp(-0.5 * t * t);
}

struct Color {
    double c[3];
};

/// What monochromatic light looks like, in linear Rec. 709 (not within its gamut). The color
/// matching functions are the fits to those of the CIE 1931 observer by Wyman, Sloan and Shirley
/// 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2),
/// equation 4; the matrix is that of IEC 61966-2-1.
Color rec709(double nm) {
    const double x = lobe(nm, 1.056, 599.8, 37.9, 31.0) + lobe(nm, 0.362, 442.0, 16.0, 26.7) +
                     lobe(nm, -0.065, 501.1, 20.4, 26.2);
    const double y = lobe(nm, 0.821, 568.8, 46.9, 40.5) + lobe(nm, 0.286, 530.9, 16.3, 31.1);
    const double z = lobe(nm, 1.217, 437.0, 11.8, 36.0) + lobe(nm, 0.681, 459.0, 26.0, 13.8);
    return {{3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
             0.0557 * x - 0.2040 * y + 1.0570 * z}};
}

/// The color of the spectrum that `value` gives at each wavelength index, not normalized.
template <typename F>
Color colorOf(F value) {
    Color sum{};
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const Color response = rec709(wavelength(i));
        for (std::size_t c = 0; c < 3; ++c) sum.c[c] += response.c[c] * value(i);
    }
    return sum;
}

Float3 ratio(const Color& a, const Color& b) {
    return {static_cast<float>(a.c[0] / b.c[0]), static_cast<float>(a.c[1] / b.c[1]),
            static_cast<float>(a.c[2] / b.c[2])};
}

} // namespace

CornellColors cornellColors() {
    const auto light = [](std::size_t i) { return lightAt(wavelength(i)); };
    const Color incoming = colorOf(light);
    const auto reflectance = [&](const Spectrum& surface) {
        return ratio(colorOf([&](std::size_t i) { return light(i) * surface[i]; }), incoming);
    };
    return {ratio(incoming, colorOf([](std::size_t) { return 1.0; })), reflectance(kWhite),
            reflectance(kRed), reflectance(kGreen)};
}

} // namespace wellstrat::render
