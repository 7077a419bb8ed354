// SPDX-License-Identifier: Apache-2.0
//
// Unit square to the side of a cylinder, with equal areas. Conventions are in warp.h.

#pragma once

#include "wellstrat/warp/angle.h"

namespace wellstrat {
inline namespace stream1 {

/// A point with x^2 + y^2 = 1 and z in [0, 1): height xi.x, azimuth xi.y. Scaling x and y by a
/// radius and z by a height keeps areas equal; the density is then divided by both.
WELLSTRAT_HOST_DEVICE inline Float3 squareToCylinder(Float2 xi) {
    const Float2 xy = detail::polarPoint(1.0f, xi.y);
    return {xy.x, xy.y, xi.x};
}

WELLSTRAT_HOST_DEVICE inline Float2 cylinderToSquare(Float3 p) {
    return {detail::clampToUnit(p.z), detail::azimuthTurn(p.x, p.y)};
}

/// Per unit area.
WELLSTRAT_HOST_DEVICE constexpr float cylinderPdf() { return detail::kInvTwoPi; }

} // namespace stream1
} // namespace wellstrat
