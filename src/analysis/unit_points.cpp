// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/unit_points.h"

#include "point_checks.h"

#include <utility>

namespace wellstrat {
inline namespace stream1 {

UnitPoints::UnitPoints(const double* values, std::size_t count, unsigned dims) {
    checkDimensions<PointError>(dims, kMaxDimensions);
    if (count == 0) throw PointError("there are no points; accepted are one or more");
    coordinates_.resize(dims, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        for (unsigned d = 0; d < dims; ++d) {
            checkValue<PointError>(values[i * dims + d], i, d);
            coordinates_[d][i] = values[i * dims + d];
        }
    }
}

UnitPoints::UnitPoints(std::vector<std::vector<double>> coordinates)
    : coordinates_(std::move(coordinates)) {}

UnitPoints UnitPoints::projection(const std::vector<unsigned>& dims) const {
    checkDimensions<PointError>(dims.size(), kMaxDimensions);
    std::vector<std::vector<double>> chosen;
    for (const unsigned dim : dims) {
        checkCoordinateExists<PointError>(dim, this->dims());
        chosen.push_back(coordinates_[dim]);
    }
    return UnitPoints(std::move(chosen));
}

} // namespace stream1
} // namespace wellstrat
