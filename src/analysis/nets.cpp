// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/nets.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace wellstrat {
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
    if (!(value >= 0 && value < 1)) {
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
        throw NetError("coordinate " + std::to_string(dim) + " of point " + std::to_string(point) +
                       " is " + text + "; accepted are values in [0, 1)");
    }
    // Scaling by a power of two is exact, the conversion rounds down.
    return static_cast<uint32_t>(value * static_cast<Real>(0x1p32));
}

uint32_t fractionOf(uint32_t value, std::size_t, unsigned) { return value; }

unsigned digitBits(NetBase base) { return base == NetBase::four ? 2 : 1; }

/// The first `width` bits of a fraction of 2^32, width in [0, 31].
uint32_t leadingBits(uint32_t fraction, unsigned width) { return (fraction >> 1) >> (31 - width); }

enum class Stop { never, atFirstViolation };

/// Counts points in elementary intervals. All aligned blocks of 2^blockLog2 points are counted in
/// one pass: an interval's number is the block, then the leading bits of each coordinate.
///
/// The shapes of intervals are the ways to hand out the digits to the coordinates, one after the
/// other. `cell_[d]` holds the numbers with the first d coordinates, and serves all shapes that
/// agree in these.
class IntervalCounter {
public:
    IntervalCounter(const PointSet& points, NetBase base, Stop stop)
        : points_(points), digitBits_(digitBits(base)), stop_(stop), count_(points.count()) {
        for (unsigned d = 0; d < points.dims(); ++d) cell_[d].resize(points.count());
    }

    /// Checks all blocks of 2^blockLog2 points; both arguments are in bits, multiples of a digit's.
    void checkBlocks(unsigned blockLog2, unsigned tLog2) {
        blockLog2_ = blockLog2;
        tLog2_ = tLog2;
        for (std::size_t i = 0; i < points_.count(); ++i) {
            cell_[0][i] = static_cast<uint32_t>(i >> blockLog2);
        }
        splitFrom(0, blockLog2 - tLog2);
    }

    const NetReport& report() const { return report_; }
    bool done() const { return stop_ == Stop::atFirstViolation && !report_.holds(); }

private:
    void splitFrom(unsigned dim, unsigned bits) {
        if (dim + 1 == points_.dims()) {
            width_[dim] = bits;
            countShape();
            return;
        }
        const std::size_t points = points_.count();
        const uint32_t* x = points_.coordinate(dim);
        const uint32_t* from = cell_[dim].data();
        uint32_t* to = cell_[dim + 1].data();
        for (unsigned width = 0; width <= bits; width += digitBits_) {
            width_[dim] = width;
            for (std::size_t i = 0; i < points; ++i) {
                to[i] = (from[i] << width) | leadingBits(x[i], width);
            }
            splitFrom(dim + 1, bits - width);
            if (done()) return;
        }
    }

    void countShape() {
        const std::size_t points = points_.count();
        const unsigned last = points_.dims() - 1;
        const uint32_t* x = points_.coordinate(last);
        const uint32_t* from = cell_[last].data();
        const unsigned width = width_[last];
        const std::size_t intervals = points >> tLog2_;
        std::fill_n(count_.begin(), intervals, 0u);
        uint32_t* count = count_.data();
        for (std::size_t i = 0; i < points; ++i) {
            ++count[(from[i] << width) | leadingBits(x[i], width)];
        }
        const uint32_t promised = 1u << tLog2_;
        const auto kept = std::count(count, count + intervals, promised);
        const uint64_t violations = intervals - static_cast<uint64_t>(kept);
        if (violations > 0 && report_.holds()) {
            const uint32_t* first =
                std::find_if(count, count + intervals, [&](uint32_t n) { return n != promised; });
            report_.firstViolation = describe(static_cast<std::size_t>(first - count), *first);
        }
        report_.intervals += intervals;
        report_.violations += violations;
    }

    std::string describe(std::size_t interval, uint32_t found) const {
        std::string box;
        for (unsigned d = points_.dims(); d-- > 0;) {
            const std::size_t parts = std::size_t{1} << width_[d];
            const std::size_t part = interval & (parts - 1);
            interval >>= width_[d];
            const std::string denominator = "/" + std::to_string(parts);
            const std::string side = parts == 1 ? "[0, 1)"
                                                : "[" + std::to_string(part) + denominator + ", " +
                                                      std::to_string(part + 1) + denominator + ")";
            box = box.empty() ? side : side + " x " + box;
        }
        const std::size_t first = interval << blockLog2_;
        const std::size_t end = first + (std::size_t{1} << blockLog2_);
        return "points [" + std::to_string(first) + ", " + std::to_string(end) + "): " + box +
               " holds " + std::to_string(found) + ", not " + std::to_string(1u << tLog2_);
    }

    const PointSet& points_;
    const unsigned digitBits_;
    const Stop stop_;
    unsigned blockLog2_ = 0;
    unsigned tLog2_ = 0;
    std::array<std::vector<uint32_t>, kMaxNetDimensions> cell_;
    std::array<unsigned, kMaxNetDimensions> width_{};
    std::vector<uint32_t> count_;
    NetReport report_;
};

NetReport sequenceReport(const PointSet& points, unsigned t, NetBase base, Stop stop) {
    IntervalCounter counter(points, base, stop);
    const unsigned bits = digitBits(base);
    const unsigned longest = points.countLog2() / bits;
    for (unsigned m = 0; m <= longest && !counter.done(); ++m) {
        counter.checkBlocks(m * bits, std::min(t, m) * bits);
    }
    return counter.report();
}

/// The smallest t in [0, m] for which holds(t); m always does.
template <class Holds>
unsigned smallestT(unsigned m, const Holds& holds) {
    unsigned t = 0;
    while (t < m && !holds(t)) ++t;
    return t;
}

} // namespace

PointSet::PointSet(std::size_t count, unsigned dims) : countLog2_(log2OfCount(count)) {
    if (dims == 0 || dims > kMaxNetDimensions) {
        throw NetError("the number of dimensions is " + std::to_string(dims) +
                       "; accepted are 1 to " + std::to_string(kMaxNetDimensions));
    }
    coordinates_.resize(dims, std::vector<uint32_t>(count));
}

template <class Value>
PointSet PointSet::fromValues(const Value* values, std::size_t count, unsigned dims) {
    PointSet set(count, dims);
    for (std::size_t i = 0; i < count; ++i) {
        for (unsigned d = 0; d < dims; ++d) {
            set.coordinates_[d][i] = fractionOf(values[i * dims + d], i, d);
        }
    }
    return set;
}

PointSet PointSet::fromIntegers(const uint32_t* values, std::size_t count, unsigned dims) {
    return fromValues(values, count, dims);
}

PointSet PointSet::fromFloats(const float* values, std::size_t count, unsigned dims) {
    return fromValues(values, count, dims);
}

PointSet PointSet::fromFloats(const double* values, std::size_t count, unsigned dims) {
    return fromValues(values, count, dims);
}

PointSet PointSet::projection(const std::vector<unsigned>& dims) const {
    PointSet set(count(), static_cast<unsigned>(dims.size()));
    for (std::size_t d = 0; d < dims.size(); ++d) {
        if (dims[d] >= this->dims()) {
            throw NetError("coordinate " + std::to_string(dims[d]) +
                           " does not exist; the points have " + std::to_string(this->dims()));
        }
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

NetReport& NetReport::operator+=(const NetReport& other) {
    if (holds()) firstViolation = other.firstViolation;
    intervals += other.intervals;
    violations += other.violations;
    return *this;
}

NetReport checkNet(const PointSet& points, unsigned t, NetBase base) {
    const unsigned bits = digitBits(base);
    if (points.countLog2() % bits != 0) {
        throw NetError(std::to_string(points.count()) + " points are no net in base 4; accepted " +
                       "are powers of four");
    }
    const unsigned m = points.countLog2() / bits;
    if (t > m) {
        throw NetError("t is " + std::to_string(t) + "; accepted for " +
                       std::to_string(points.count()) + " points are 0 to " + std::to_string(m));
    }
    IntervalCounter counter(points, base, Stop::never);
    counter.checkBlocks(m * bits, t * bits);
    return counter.report();
}

NetReport checkSequence(const PointSet& points, unsigned t, NetBase base) {
    return sequenceReport(points, t, base, Stop::never);
}

NetReport checkStrata(const PointSet& points, unsigned dim) {
    return checkNet(points.projection({dim}), 0);
}

unsigned tValue(const PointSet& points) {
    return smallestT(points.countLog2(), [&](unsigned t) {
        IntervalCounter counter(points, NetBase::two, Stop::atFirstViolation);
        counter.checkBlocks(points.countLog2(), t);
        return counter.report().holds();
    });
}

unsigned tValueOfSequence(const PointSet& points) {
    return smallestT(points.countLog2(), [&](unsigned t) {
        return sequenceReport(points, t, NetBase::two, Stop::atFirstViolation).holds();
    });
}

} // namespace wellstrat
