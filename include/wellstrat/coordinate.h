// SPDX-License-Identifier: Apache-2.0
//
// The axes of a three-dimensional sample.

#pragma once

#include "wellstrat/platform.h"

namespace wellstrat {
inline namespace stream1 {

/// A 2D draw gives (x, y), a 1D draw z.
enum class Coordinate : unsigned { x = 0, y = 1, z = 2 };

} // namespace stream1
} // namespace wellstrat
