// SPDX-License-Identifier: Apache-2.0
//
// The Fourier transform of points in the plane by Gaussian gridding.
// Greengard, Lee 2004, "Accelerating the nonuniform fast Fourier transform", SIAM Review 46,
// section 2: spread each point as a Gaussian over a grid, transform, divide by the Gaussian's own
// transform.

#pragma once

#include "wellstrat/analysis/unit_points.h"

#include <complex>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// sum_j exp(-2 pi i f.x_j) for fx in [-maxFrequency, maxFrequency] and fy in [0, maxFrequency],
/// fx fastest.
std::vector<std::complex<double>> planeSums(const UnitPoints& points, int maxFrequency);

} // namespace stream1
} // namespace wellstrat
