// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/unit_points.h"

#include <cstdio>
#include <string>
#include <utility>

namespace wellstrat {
namespace {

void checkDimensions(std::size_t dims) {
    if (dims >= 1 && dims <= UnitPoints::kMaxDimensions) return;
    throw PointError("the number of dimensions is " + std::to_string(dims) +
                     "; accepted are 1 to " + std::to_string(UnitPoints::kMaxDimensions));
}

void checkValue(double value, std::size_t point, unsigned dim) {
    if (value >= 0 && value < 1) return;
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    throw PointError("coordinate " + std::to_string(dim) + " of point " + std::to_string(point) +
                     " is " + text + "; accepted are values in [0, 1)");
}

} // namespace

UnitPoints::UnitPoints(const double* values, std::size_t count, unsigned dims) {
    checkDimensions(dims);
    if (count == 0) throw PointError("there are no points; accepted are one or more");
    coordinates_.resize(dims, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        for (unsigned d = 0; d < dims; ++d) {
            checkValue(values[i * dims + d], i, d);
            coordinates_[d][i] = values[i * dims + d];
        }
    }
}

UnitPoints::UnitPoints(std::vector<std::vector<double>> coordinates)
    : coordinates_(std::move(coordinates)) {}

UnitPoints UnitPoints::projection(const std::vector<unsigned>& dims) const {
    checkDimensions(dims.size());
    std::vector<std::vector<double>> chosen;
    for (const unsigned dim : dims) {
        if (dim >= this->dims()) {
            throw PointError("coordinate " + std::to_string(dim) +
                             " does not exist; the points have " + std::to_string(this->dims()));
        }
        chosen.push_back(coordinates_[dim]);
    }
    return UnitPoints(std::move(chosen));
}

} // namespace wellstrat
