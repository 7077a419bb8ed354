// SPDX-License-Identifier: Apache-2.0
//
// Points that were read, and how many may be.

#pragma once

#include <cstddef>
#include <vector>

namespace wellstrat::cli {

/// Points in [0, 1)^dims, point after point.
struct PointTable {
    std::vector<double> values;
    unsigned dims = 0;

    std::size_t count() const { return values.size() / dims; }
};

/// Sets of equally many points, such as the randomizations of one sequence, set after set.
struct PatternTable {
    PointTable points;
    std::size_t patterns = 1;

    std::size_t pointsEach() const { return points.count() / patterns; }
};

/// More points than this are not read as one set,
constexpr std::size_t kMaxFilePoints = std::size_t{1} << 20;
/// and not more numbers from a file.
constexpr std::size_t kMaxFileNumbers = std::size_t{1} << 25;

} // namespace wellstrat::cli
