// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/nets.h"

#include <algorithm>
#include <array>

namespace wellstrat {
inline namespace stream1 {
namespace {

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

    /// The interval that the last `width` bits of an interval's number stand for.
    static std::string side(std::size_t interval, unsigned width) {
        if (width == 0) return "[0, 1)";
        const std::size_t parts = std::size_t{1} << width;
        const std::size_t part = interval % parts;
        const std::string over = "/" + std::to_string(parts);
        return "[" + std::to_string(part) + over + ", " + std::to_string(part + 1) + over + ")";
    }

    std::string describe(std::size_t interval, uint32_t found) const {
        std::string box;
        for (unsigned d = points_.dims(); d-- > 0;) {
            box.insert(0, (d == 0 ? "" : " x ") + side(interval, width_[d]));
            interval >>= width_[d];
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
    std::array<std::vector<uint32_t>, PointSet::kMaxDimensions> cell_;
    std::array<unsigned, PointSet::kMaxDimensions> width_{};
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

} // namespace stream1
} // namespace wellstrat
