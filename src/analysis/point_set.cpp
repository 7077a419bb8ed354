// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/point_set.h"

#include "point_checks.h"

#include <algorithm>

namespace wellstrat {
inline namespace stream1 {
namespace {

unsigned log2Floor(std::size_t n) {
    unsigned log2 = 0;
    while (n >>= 1) ++log2;
    return log2;
}

unsigned log2OfCount(std::size_t count) {
    if (count == 0 || (count & (count - 1)) != 0 || count > (std::size_t{1} << 31)) {
        throw NetError("the number of points is " + std::to_string(count) +
                       "; accepted are powers of two from 1 to 2^31");
    }
    return log2Floor(count);
}

template <class Real>
uint32_t fractionOf(Real value, std::size_t point, unsigned dim) {
    checkValue<NetError>(static_cast<double>(value), point, dim);
    // Scaling by a power of two is exact, the conversion rounds down.
    return static_cast<uint32_t>(value * static_cast<Real>(0x1p32));
}

uint32_t fractionOf(uint32_t value, std::size_t, unsigned) { return value; }

/// Coordinate d of point i from values[i * dims + d].
template <class Value>
void setCoordinates(std::vector<std::vector<uint32_t>>& coordinates, const Value* values) {
    const auto dims = static_cast<unsigned>(coordinates.size());
    for (std::size_t i = 0; i < coordinates.front().size(); ++i) {
        for (unsigned d = 0; d < dims; ++d) {
            coordinates[d][i] = fractionOf(values[i * dims + d], i, d);
        }
    }
}

} // namespace

PointSet::PointSet(std::size_t count, unsigned dims) : countLog2_(log2OfCount(count)) {
    checkDimensions<NetError>(dims, kMaxDimensions);
    coordinates_.resize(dims, std::vector<uint32_t>(count));
}

PointSet PointSet::fromIntegers(const uint32_t* values, std::size_t count, unsigned dims) {
    PointSet set(count, dims);
    setCoordinates(set.coordinates_, values);
    return set;
}

PointSet PointSet::fromFloats(const float* values, std::size_t count, unsigned dims) {
    PointSet set(count, dims);
    setCoordinates(set.coordinates_, values);
    return set;
}

PointSet PointSet::fromFloats(const double* values, std::size_t count, unsigned dims) {
    PointSet set(count, dims);
    setCoordinates(set.coordinates_, values);
    return set;
}

PointSet PointSet::projection(const std::vector<unsigned>& dims) const {
    PointSet set(count(), static_cast<unsigned>(dims.size()));
    for (std::size_t d = 0; d < dims.size(); ++d) {
        checkCoordinateExists<NetError>(dims[d], this->dims());
        set.coordinates_[d] = coordinates_[dims[d]];
    }
    return set;
}

PointSet PointSet::block(std::size_t first, std::size_t count) const {
    PointSet set(count, dims());
    if (count > this->count() || first > this->count() - count) {
        throw NetError("points " + std::to_string(first) + " to " +
                       std::to_string(first + count - 1) + " are asked for; the set has " +
                       std::to_string(this->count()));
    }
    for (unsigned d = 0; d < dims(); ++d) {
        std::copy_n(coordinate(d) + first, count, set.coordinates_[d].begin());
    }
    return set;
}

} // namespace stream1
} // namespace wellstrat
