// SPDX-License-Identifier: Apache-2.0
//
// Point sets in the unit cube, as the exact checks of nets.h take them.

#pragma once

#include "wellstrat/platform.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// Thrown for input that is no point set of a net; what() says which value is wrong and what is
/// accepted.
class WELLSTRAT_API NetError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// A finite sequence of points in [0, 1)^s, 1 <= s <= kMaxDimensions, kept as fractions of 2^32.
/// The number of points is a power of two up to 2^31. Immutable; any number of threads may read one
/// at once.
class WELLSTRAT_API PointSet {
public:
    static constexpr unsigned kMaxDimensions = 6;

    /// Copies values[0, count * dims), point after point: coordinate d of point i is
    /// values[i * dims + d]. Integers are fractions of 2^32. Floating-point values are rounded down
    /// to such fractions, which moves no value across a boundary of an interval. Throws NetError
    /// for a count or number of dimensions out of range and for a value that is NaN or outside
    /// [0, 1), whose place it names.
    static PointSet fromIntegers(const uint32_t* values, std::size_t count, unsigned dims);
    static PointSet fromFloats(const float* values, std::size_t count, unsigned dims);
    static PointSet fromFloats(const double* values, std::size_t count, unsigned dims);

    std::size_t count() const { return std::size_t{1} << countLog2_; }
    unsigned countLog2() const { return countLog2_; }
    unsigned dims() const { return static_cast<unsigned>(coordinates_.size()); }
    /// Coordinate `dim` in [0, dims()) of all points in order, valid as long as this object.
    const uint32_t* coordinate(unsigned dim) const { return coordinates_[dim].data(); }

    /// The same points with only the coordinates `dims`, in that order. Throws NetError for a
    /// coordinate that does not exist, and for none or more than
    /// kMaxDimensions.
    PointSet projection(const std::vector<unsigned>& dims) const;
    /// Points [first, first + count) of the sequence. Throws NetError unless `count` is a power of
    /// two and the range lies in the sequence.
    PointSet block(std::size_t first, std::size_t count) const;

private:
    PointSet(std::size_t count, unsigned dims);

    unsigned countLog2_;
    std::vector<std::vector<uint32_t>> coordinates_;
};

} // namespace stream1
} // namespace wellstrat
