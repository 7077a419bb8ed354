// SPDX-License-Identifier: Apache-2.0
//
// The bxdf of renderer/bxdf.h, written again in double precision from the textbook terms D, G and
// F, and its albedo by quadrature.

#pragma once

#include "renderer/color.h"
#include "renderer/scene.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render::reference {

constexpr double kPi = 3.14159265358979323846;

/// A direction in the frame of the surface.
struct Direction {
    double x, y, z;
};

inline double fresnel(double f0, double f90, double cosine) {
    return f0 + (f90 - f0) * std::pow(1 - cosine, 5);
}

/// Smith's masking of GGX for one direction, as the Lambda of Heitz 2014, equation 72.
inline double lambda(double alpha, double z) {
    const double tanSquared = (1 - z * z) / (z * z);
    return (std::sqrt(1 + alpha * alpha * tanSquared) - 1) / 2;
}

/// What the dielectric of a material lets through its surface, at a cosine and on average.
inline double through(const Material& m, double cosine) {
    return 1 - fresnel(m.specularF0, std::min(1.0, 25.0 * m.specularF0), cosine);
}
inline double meanThrough(const Material& m) {
    return 1 - m.specularF0 - (std::min(1.0, 25.0 * m.specularF0) - m.specularF0) / 21;
}

/// A channel of the diffuse lobe of an untextured material, without a cosine.
inline double diffuse(const Material& m, int channel, Direction in, Direction out) {
    return (1.0 - m.metallic) * m.baseColor[channel] / kPi * through(m, in.z) * through(m, out.z) /
           meanThrough(m);
}

/// Of the specular lobe.
inline double specular(const Material& m, int channel, Direction in, Direction out) {
    Direction half{in.x + out.x, in.y + out.y, in.z + out.z};
    const double length = std::sqrt(half.x * half.x + half.y * half.y + half.z * half.z);
    half = {half.x / length, half.y / length, half.z / length};
    const double alpha = std::max(double{m.roughness} * m.roughness, std::pow(2, -10));
    const double base = half.z * half.z * (alpha * alpha - 1) + 1;
    const double d = alpha * alpha / (kPi * base * base);
    const double g = 1 / (1 + lambda(alpha, in.z) + lambda(alpha, out.z));
    const auto f0Of = [&](int c) {
        return m.specularF0 + double{m.metallic} * (m.baseColor[c] - m.specularF0);
    };
    const double f90 = std::min(1.0, 25 * std::max({f0Of(0), f0Of(1), f0Of(2)}));
    const double cosine = in.x * half.x + in.y * half.y + in.z * half.z;
    return d * g * fresnel(f0Of(channel), f90, cosine) / (4 * in.z * out.z);
}

/// The light that a smooth boundary reflects, by the amplitudes of Fresnel; `eta` is the index of
/// refraction on the side of the light over that behind.
inline double fresnelReflection(double eta, double cosine) {
    const double sineBehind = eta * std::sqrt(1 - cosine * cosine);
    if (sineBehind >= 1) return 1;
    const double behind = std::sqrt(1 - sineBehind * sineBehind);
    const double across = (eta * cosine - behind) / (eta * cosine + behind);
    const double along = (cosine - eta * behind) / (cosine + eta * behind);
    return (across * across + along * along) / 2;
}

inline double dot(Direction a, Direction b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// What of a clear white material of roughness `roughness` passes from `in` to `out`, on different
/// sides, without a cosine: Walter 2007, equation 21, over the squared index on the side of `out`
/// and times that on the side of `in`. `eta` is the index on the side of `out` over the other.
inline double refracted(double roughness, double eta, Direction in, Direction out) {
    Direction half{-(eta * out.x + in.x), -(eta * out.y + in.y), -(eta * out.z + in.z)};
    const double length = std::sqrt(dot(half, half)) * (half.z * out.z < 0 ? -1 : 1);
    half = {half.x / length, half.y / length, half.z / length};
    const double o = dot(out, half), i = dot(in, half);
    if (o <= 0 || i >= 0) return 0;
    const double alpha = roughness * roughness;
    const double base = half.z * half.z * (alpha * alpha - 1) + 1;
    const double d = alpha * alpha / (kPi * base * base);
    const double g = 1 / (1 + lambda(alpha, std::fabs(in.z)) + lambda(alpha, std::fabs(out.z)));
    const double root = i + eta * o;
    return o * -i / std::fabs(out.z * in.z) * (1 - fresnelReflection(eta, o)) * g * d /
           (root * root);
}

/// The light that comes back towards a direction with this cosine, of even light of radiance 1: of
/// the specular lobe by the midpoint rule over the slope of the half vector and its azimuth; of the
/// diffuse lobe exactly, for the integral over the way in is meanThrough().
inline Float3 albedo(const Material& m, double cosine) {
    const Direction out{std::sqrt(1 - cosine * cosine), 0, cosine};
    // Microfacet normals h with tan(theta) = scale t / (1 - t): in = reflect(out, h), and
    // d(in) = 4 (out.h) d(h). All directions above the surface have such an h.
    constexpr int kSteps = 2000;
    constexpr int kTurns = 500;
    const double scale = std::max(double{m.roughness} * m.roughness, std::pow(2, -10));
    double sum[3];
    for (int c = 0; c < 3; ++c) sum[c] = (1.0 - m.metallic) * m.baseColor[c] * through(m, cosine);
    for (int i = 0; i < kSteps; ++i) {
        const double t = (i + 0.5) / kSteps;
        const double tangent = scale * t / (1 - t);
        const double z = 1 / std::sqrt(1 + tangent * tangent);
        // d(theta) = cos^2(theta) d(tan); solid angle sin(theta) d(theta) d(phi)
        const double ring = tangent * z * z * z * scale / ((1 - t) * (1 - t)) / kSteps;
        for (int j = 0; j < kTurns; ++j) {
            const double phi = kPi * (j + 0.5) / kTurns; // half of the turn, by symmetry
            const Direction h{tangent * z * std::cos(phi), tangent * z * std::sin(phi), z};
            const double across = out.x * h.x + out.z * h.z;
            const Direction in{2 * across * h.x - out.x, 2 * across * h.y,
                               2 * across * h.z - out.z};
            if (across <= 0 || in.z <= 0) continue;
            const double weight = 4 * across * ring * (2 * kPi / kTurns) * in.z;
            for (int c = 0; c < 3; ++c) sum[c] += weight * specular(m, c, in, out);
        }
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

} // namespace wellstrat::render::reference
