// SPDX-License-Identifier: Apache-2.0
//
// What surfaces reflect, from what they reflect at normal incidence: Schlick 1994, "An Inexpensive
// BRDF Model for Physically-based Rendering", equation 15.

#pragma once

#include "color.h"

#include <algorithm>

namespace wellstrat::render {

/// What reflects less than 4 % at normal incidence reflects less than all at grazing incidence,
/// down to nothing at all.
struct Schlick {
    float f0;

    float f90() const { return std::min(1.0f, 25.0f * f0); }
    float at(float cosine) const {
        const float x = std::max(0.0f, 1.0f - cosine);
        return f0 + (f90() - f0) * (x * x) * (x * x) * x;
    }
    /// The mean over the hemisphere, by the cosine.
    float mean() const { return f0 + (f90() - f0) * (1.0f / 21.0f); }
};

/// Of colors, with one grazing value for all channels: the color fades away there.
inline Float3 schlick(Float3 f0, float cosine) {
    const float f90 = Schlick{largestChannel(f0)}.f90();
    const float x = std::max(0.0f, 1.0f - cosine);
    return lerp(f0, Float3(f90), (x * x) * (x * x) * x);
}

} // namespace wellstrat::render
