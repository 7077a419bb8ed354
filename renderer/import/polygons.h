// SPDX-License-Identifier: Apache-2.0
//
// Triangles of polygons.

#pragma once

#include "wellstrat/vector.h"

#include <array>
#include <cstdint>
#include <vector>

namespace wellstrat::render {

/// Appends the triangles of a simple polygon, as indices of its corners, in its orientation: two
/// less than it has corners. It is seen along its normal (Newell's method: Sutherland, Sproull and
/// Schumacker 1974, "A Characterization of Ten Hidden-Surface Algorithms"), and, unless it is
/// convex, loses ear after ear (Meisters 1975, "Polygons have ears"). One that crosses itself, or
/// has corners that are no numbers, gets as many triangles.
void appendTriangles(const std::vector<Float3>& corners,
                     std::vector<std::array<uint32_t, 3>>& triangles);

} // namespace wellstrat::render
