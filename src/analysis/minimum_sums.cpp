// SPDX-License-Identifier: Apache-2.0

#include "minimum_sums.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// Fewer points than this are taken pair by pair.
constexpr std::ptrdiff_t kFew = 16;

template <unsigned Axes>
struct Weighted {
    std::array<double, Axes> u; ///< 1 - x
    double weight;
    unsigned char half = 0; ///< along the first of three axes
};

template <unsigned Axes>
double minimumProduct(const Weighted<Axes>& a, const Weighted<Axes>& b) {
    double product = a.weight * b.weight;
    for (unsigned d = 0; d < Axes; ++d) product *= std::min(a.u[d], b.u[d]);
    return product;
}

/// The sum over pairs of different points, each pair once. Sums of many weights are long doubles:
/// as one serves many points, its error would not average out.
template <unsigned Axes>
class PairSum {
public:
    using Point = Weighted<Axes>;

    /// `points` are in the order of their first coordinates.
    explicit PairSum(std::vector<Point> points) : spare_(points.size()) {
        if constexpr (Axes == 1) {
            addLine(points);
        } else if constexpr (Axes == 2) {
            splitSecondToLast(points.data(), points.data() + points.size());
        } else {
            scratch_.resize(points.size());
            splitFirst(points.data(), points.data() + points.size());
        }
    }

    long double sum() const { return sum_; }

private:
    static constexpr unsigned kLast = Axes - 1;
    /// Of the points of either half along the first of three axes; of two axes, the first only.
    using Halves = std::array<long double, 2>;

    template <unsigned Axis>
    static bool less(const Point& a, const Point& b) {
        return a.u[Axis] < b.u[Axis];
    }

    void addLine(const std::vector<Point>& points) {
        long double smaller = 0;
        for (const Point& point : points) {
            sum_ += point.weight * static_cast<double>(smaller);
            smaller += point.weight * point.u[0];
        }
    }

    /// Pairs among points in the order of the first of three axes. Leaves them in that of the
    /// second.
    void splitFirst(Point* begin, Point* end) {
        if (end - begin <= kFew) {
            addPairs(begin, end, minimumProduct<Axes>);
            std::sort(begin, end, less<1>);
            return;
        }
        Point* const middle = begin + (end - begin) / 2;
        splitFirst(begin, middle);
        splitFirst(middle, end);
        std::for_each(begin, middle, [](Point& point) { point.half = 0; });
        std::for_each(middle, end, [](Point& point) { point.half = 1; });
        Point* const merged = std::merge(begin, middle, middle, end, scratch_.data(), less<1>);
        std::copy(scratch_.data(), merged, begin);
        std::for_each(scratch_.data(), merged, [](Point& point) {
            if (point.half == 0) point.weight *= point.u[0];
        });
        splitSecondToLast(scratch_.data(), merged);
    }

    /// Pairs among points in the order of the axis before the last one, by the last two axes; of
    /// three axes, only pairs of points of different halves along the first, which has left the
    /// problem. Leaves them in the order of the last axis. Returns the sums of the weights times
    /// the coordinates along the axis before.
    Halves splitSecondToLast(Point* begin, Point* end) {
        Halves sums{};
        if (end - begin <= kFew) {
            addPairs(begin, end, [](const Point& a, const Point& b) {
                if (Axes == 3 && a.half == b.half) return 0.0;
                return a.weight * b.weight * std::min(a.u[kLast - 1], b.u[kLast - 1]) *
                       std::min(a.u[kLast], b.u[kLast]);
            });
            std::sort(begin, end, less<kLast>);
            for (; begin != end; ++begin) sums[begin->half] += scaled(*begin);
            return sums;
        }
        Point* const middle = begin + (end - begin) / 2;
        const Halves low = splitSecondToLast(begin, middle);
        const Halves high = splitSecondToLast(middle, end);
        addAcross(begin, middle, end, low);
        for (std::size_t half = 0; half < sums.size(); ++half) sums[half] = low[half] + high[half];
        return sums;
    }

    static double scaled(const Point& point) { return point.weight * point.u[kLast - 1]; }

    /// Pairs of a point before `middle` and one after, the former with the smaller coordinates
    /// along the axis before the last one and `low` the sums of weights times these. Merges both by
    /// their last coordinates.
    void addAcross(Point* begin, Point* middle, Point* end, const Halves& low) {
        Halves larger = low; // than that of the next point along the last axis: their weights
        Halves smaller{};    // weights times coordinates
        Point* to = spare_.data();
        Point* left = begin;
        for (Point* right = middle; right != end; ++right) {
            for (; left != middle && left->u[kLast] <= right->u[kLast]; ++left) {
                const double weight = scaled(*left);
                larger[left->half] -= weight;
                smaller[left->half] += weight * left->u[kLast];
                *to++ = *left;
            }
            const std::size_t half = Axes == 3 ? 1 - right->half : 0;
            const long double partners = smaller[half] + larger[half] * right->u[kLast];
            sum_ += right->weight * static_cast<double>(partners);
            *to++ = *right;
        }
        std::copy(left, middle, to);
        std::copy(spare_.data(), spare_.data() + (end - begin), begin);
    }

    template <class Product>
    void addPairs(const Point* begin, const Point* end, const Product& product) {
        double sum = 0;
        for (const Point* a = begin; a != end; ++a) {
            for (const Point* b = begin; b != a; ++b) sum += product(*a, *b);
        }
        sum_ += sum;
    }

    std::vector<Point> scratch_, spare_;
    long double sum_ = 0;
};

template <unsigned Axes>
long double pairSum(const UnitPoints& points, const std::vector<double>& weights,
                    const std::vector<unsigned>& axes, const std::vector<std::size_t>& order) {
    std::vector<Weighted<Axes>> weighted(order.size());
    long double own = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        weighted[k].weight = weights[order[k]];
        for (unsigned d = 0; d < Axes; ++d) {
            weighted[k].u[d] = 1 - points.coordinate(axes[d])[order[k]];
        }
        own += minimumProduct(weighted[k], weighted[k]);
    }
    return own + 2 * PairSum<Axes>(std::move(weighted)).sum();
}

} // namespace

MinimumSums::MinimumSums(const UnitPoints& points) : points_(points), order_(points.dims()) {
    for (unsigned d = 0; d < points.dims(); ++d) {
        const double* x = points.coordinate(d);
        order_[d].resize(points.count());
        std::iota(order_[d].begin(), order_[d].end(), std::size_t{0});
        std::sort(order_[d].begin(), order_[d].end(),
                  [x](std::size_t a, std::size_t b) { return x[a] > x[b]; });
    }
}

long double MinimumSums::sum(const std::vector<double>& weights,
                             const std::vector<unsigned>& axes) const {
    switch (axes.size()) {
    case 0: {
        const long double total = std::accumulate(weights.begin(), weights.end(), 0.0L);
        return total * total;
    }
    case 1: return pairSum<1>(points_, weights, axes, order_[axes[0]]);
    case 2: return pairSum<2>(points_, weights, axes, order_[axes[0]]);
    case 3: return pairSum<3>(points_, weights, axes, order_[axes[0]]);
    default: throw PointError("a product of coordinates has up to three axes");
    }
}

} // namespace stream1
} // namespace wellstrat
