// SPDX-License-Identifier: Apache-2.0
//
// Functions on the unit square with known integrals. The first four are of the kinds with
// which Christensen, Kensler and Kilpatrick 2018 compare sequences; the others have fine detail.

#pragma once

#include "statistical/exact_shuffle.h"

#include <cmath>

namespace statistical {

constexpr unsigned kIntegrands = 7;

struct Integrand {
    const char* name;
    double integral;
};

inline const Integrand kIntegrandTable[kIntegrands] = {
    {"quarter disk", 0.5},
    {"Gaussian", 0.25 * 3.14159265358979324 * std::erf(1.0) * std::erf(1.0)},
    {"triangle", 0.5},
    {"bilinear", 0.25},
    {"rings", 0.125 * 3.14159265358979324},
    {"16x16 checkerboard", 0.5},
    {"32x32 checkerboard", 0.5},
};

/// All of them at a point.
inline void evaluate(Point2 p, float values[kIntegrands]) {
    const float radius2 = p.x * p.x + p.y * p.y;
    const auto checkerboard = [&](float cells) {
        return static_cast<float>((static_cast<int>(p.x * cells) ^ static_cast<int>(p.y * cells)) &
                                  1);
    };
    values[0] = radius2 < 2 / 3.14159265f ? 1.0f : 0.0f;
    values[1] = std::exp(-radius2);
    values[2] = p.y < p.x ? 1.0f : 0.0f;
    values[3] = p.x * p.y;
    values[4] = radius2 < 1 && static_cast<int>(radius2 * 16) % 2 == 0 ? 1.0f : 0.0f; // equal areas
    values[5] = checkerboard(16);
    values[6] = checkerboard(32);
}

} // namespace statistical
