// SPDX-License-Identifier: Apache-2.0
//
// Affine maps of space, such as the places of nodes.

#pragma once

#include "wellstrat/vector.h"

#include <cmath>

namespace wellstrat::render {

inline bool isFinite(Float3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Maps a point p to x p.x + y p.y + z p.z + origin.
struct Affine {
    Float3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}; ///< where the unit vectors go
    Float3 origin{0, 0, 0};                    ///< where the origin goes

    Float3 vector(Float3 v) const { return x * v.x + y * v.y + z * v.z; }
    Float3 point(Float3 p) const { return vector(p) + origin; }

    /// Of any length, in the direction of the normal of what `normal` was across. The rows of the
    /// cofactor matrix are the normals of the faces of the unit cube.
    Float3 normal(Float3 n) const {
        const Float3 sum = Cross(y, z) * n.x + Cross(z, x) * n.y + Cross(x, y) * n.z;
        return isMirroring() ? -sum : sum;
    }

    bool isMirroring() const { return Dot(Cross(x, y), z) < 0.0f; }

    /// First `inner`, then this.
    Affine operator*(const Affine& inner) const {
        return {vector(inner.x), vector(inner.y), vector(inner.z), point(inner.origin)};
    }
};

} // namespace wellstrat::render
