// SPDX-License-Identifier: Apache-2.0
//
// The exact volume of a half-space in the unit cube.

#pragma once

#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The volume of { x in [0,1]^s : weights . x < bound }, s = weights.size() at most 8.
///
/// With positive weights w it is the sum over the corners v of the cube of
///
///     (-1)^(v_1 + ... + v_s)  max(0, bound - w . v)^s  /  (s! w_1 ... w_s)
///
/// (Barrow and Smith 1979, "Spline Notation Applied to a Volume Problem", theorem 1). Weights of 0
/// are left out, and negative ones are made positive by x -> 1 - x.
double halfSpaceVolume(const std::vector<double>& weights, double bound);

} // namespace stream1
} // namespace wellstrat
