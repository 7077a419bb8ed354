// SPDX-License-Identifier: Apache-2.0
//
// Point sets in the unit cube with any number of points, as the measures of discrepancy.h,
// geometry.h, spectrum.h and independence.h take them.

#pragma once

#include "wellstrat/platform.h"

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// What lies beyond the border of the cube: nothing, or the opposite side.
enum class Topology { cube, torus };

/// Thrown for input that is no point set; what() says which value is wrong and what is accepted.
class WELLSTRAT_API PointError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// One or more points in [0, 1)^s, 1 <= s <= kMaxDimensions, in order. Immutable; any number of
/// threads may read one at once.
class WELLSTRAT_API UnitPoints {
public:
    static constexpr unsigned kMaxDimensions = 64;

    /// Copies values[0, count * dims), point after point: coordinate d of point i is
    /// values[i * dims + d]. Throws PointError for no points, for a number of dimensions out of
    /// range, and for a value that is NaN or outside [0, 1), whose place it names.
    UnitPoints(const double* values, std::size_t count, unsigned dims);

    std::size_t count() const { return coordinates_.front().size(); }
    unsigned dims() const { return static_cast<unsigned>(coordinates_.size()); }
    /// Coordinate `dim` in [0, dims()) of all points in order, valid as long as this object.
    const double* coordinate(unsigned dim) const { return coordinates_[dim].data(); }

    /// The same points with only the coordinates `dims`, in that order. Throws PointError for a
    /// coordinate that does not exist, and for none or more than kMaxDimensions.
    UnitPoints projection(const std::vector<unsigned>& dims) const;

private:
    explicit UnitPoints(std::vector<std::vector<double>> coordinates);

    std::vector<std::vector<double>> coordinates_;
};

} // namespace stream1
} // namespace wellstrat
