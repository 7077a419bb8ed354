// SPDX-License-Identifier: Apache-2.0
//
// What all readers of materials do alike.

#pragma once

#include "../color.h"
#include "../scene.h"
#include "notes.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

/// The nearest number, or color, in [0, 1]; with a note if it is another.
template <typename T>
T inUnitRange(T value, Notes& notes) {
    const T result = clamp01(value);
    if (!(result == value))
        notes.add("Material numbers outside [0, 1] are replaced by the nearest in it.");
    return result;
}

/// With 0, and a note, for what is negative or not finite.
inline Float3 notNegative(Float3 color, Notes& notes) {
    for (int c = 0; c < 3; ++c) {
        if (color[c] >= 0.0f && std::isfinite(color[c])) continue;
        color[c] = 0;
        notes.add("Colors of light that are negative or no numbers are replaced by 0.");
    }
    return color;
}

/// What a dielectric reflects at normal incidence, by Fresnel's equations.
inline float reflectanceOf(float indexOfRefraction) {
    const float root = (indexOfRefraction - 1) / (indexOfRefraction + 1);
    return clamp01(root * root);
}

/// Makes a surface of base color reflect as those of older formats, which have a specular color and
/// Phong's exponent n: alpha of GGX is sqrt(2 / (n + 2)) (Walter et al. 2007, "Microfacet Models
/// for Refraction through Rough Surfaces", section 5.2), and specularF0 is 0.08 times the specular
/// color, as in Burley 2012, "Physically-Based Shading at Disney"; where the base color is black
/// and has no texture, it is a metal of the specular color.
inline void makePhong(Material& material, Float3 specular, float exponent, bool hasColorTexture) {
    material.roughness = clamp01(std::pow(2 / (std::max(exponent, 0.0f) + 2), 0.25f));
    if (isBlack(material.baseColor) && !isBlack(specular) && !hasColorTexture) {
        material.baseColor = specular;
        material.metallic = 1;
    } else {
        material.specularF0 = 0.08f * largestChannel(specular);
    }
}

} // namespace wellstrat::render
