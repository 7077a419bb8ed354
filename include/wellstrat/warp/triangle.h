// SPDX-License-Identifier: Apache-2.0
//
// Unit square to triangle, with equal areas. Conventions are in warp.h.

#pragma once

#include "wellstrat/warp/angle.h"

namespace wellstrat {
inline namespace stream1 {

/// Barycentric coordinates: the weights of the first two corners; that of the third is 1 - x - y.
/// All are at least 0. Folds the square onto the triangle with low distortion, without a square
/// root: Heitz 2019, "A Low-Distortion Map Between Triangle and Square", section 2.
WELLSTRAT_HOST_DEVICE constexpr Float2 squareToTriangle(Float2 xi) {
    if (xi.y > xi.x) return {0.5f * xi.x, xi.y - 0.5f * xi.x};
    return {xi.x - 0.5f * xi.y, 0.5f * xi.y};
}

WELLSTRAT_HOST_DEVICE constexpr Float2 triangleToSquare(Float2 barycentric) {
    const float sum = detail::clampToUnit(barycentric.x + barycentric.y);
    if (barycentric.y > barycentric.x) return {2.0f * barycentric.x, sum};
    return {sum, 2.0f * barycentric.y};
}

/// Per unit of the barycentric coordinates, whose triangle has the area 1/2.
WELLSTRAT_HOST_DEVICE constexpr float trianglePdf() { return 2.0f; }

/// The point with these barycentric coordinates of the triangle (a, b, c).
WELLSTRAT_HOST_DEVICE constexpr Float3 squareToTriangle(Float2 xi, Float3 a, Float3 b, Float3 c) {
    const Float2 weight = squareToTriangle(xi);
    return a * weight.x + b * weight.y + c * (1.0f - weight.x - weight.y);
}

/// Per unit area of the triangle (a, b, c): one over its area, infinite if that is 0.
WELLSTRAT_HOST_DEVICE inline float trianglePdf(Float3 a, Float3 b, Float3 c) {
    return 2.0f / Cross(b - a, c - a).Length();
}

} // namespace stream1
} // namespace wellstrat
