// SPDX-License-Identifier: Apache-2.0

#include "distance_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// Fewer points than this are taken pair by pair.
constexpr std::ptrdiff_t kFew = 16;

template <unsigned Axes>
struct Weighted {
    std::array<double, Axes> x;
    double weight;
    unsigned char half = 0; ///< along the first axis
};

template <unsigned Axes>
double distanceProduct(const Weighted<Axes>& a, const Weighted<Axes>& b) {
    double product = a.weight * b.weight;
    for (unsigned d = 0; d < Axes; ++d) product *= std::fabs(a.x[d] - b.x[d]);
    return product;
}

/// What has to be known of points to sum the products of their distances to one that is in front
/// of them along all axes: sums_[m] = sum_j w_j prod_(d in m) x_jd for each set of axes m. Long
/// doubles, as the same sum serves many points: its error would not average out.
template <unsigned Axes>
class Moments {
public:
    void add(const Weighted<Axes>& point, double weight) {
        std::array<double, kSets> products;
        products[0] = weight;
        for (unsigned d = 0; d < Axes; ++d) {
            for (unsigned m = 0; m < 1u << d; ++m) products[m | 1u << d] = products[m] * point.x[d];
        }
        for (unsigned m = 0; m < kSets; ++m) sums_[m] += products[m];
    }

    Moments& operator+=(const Moments& other) {
        for (unsigned m = 0; m < kSets; ++m) sums_[m] += other.sums_[m];
        return *this;
    }

    Moments operator-() const {
        Moments result;
        for (unsigned m = 0; m < kSets; ++m) result.sums_[m] = -sums_[m];
        return result;
    }

    /// sum_j w_j prod_d (x_d - x_jd)
    double products(const std::array<double, Axes>& x) const {
        std::array<long double, kSets> rest = sums_;
        for (unsigned d = Axes; d-- > 0;) {
            for (unsigned m = 0; m < 1u << d; ++m) rest[m] = rest[m] * x[d] - rest[m | 1u << d];
        }
        return static_cast<double>(rest[0]);
    }

private:
    static constexpr unsigned kSets = 1u << Axes;
    std::array<long double, kSets> sums_{};
};

/// The sum over pairs of points, each pair once.
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
    using Halves = std::array<Moments<Axes>, 2>;

    template <unsigned Axis>
    static bool less(const Point& a, const Point& b) {
        return a.x[Axis] < b.x[Axis];
    }

    void addLine(const std::vector<Point>& points) {
        Moments<Axes> before;
        for (const Point& point : points) {
            sum_ += point.weight * before.products(point.x);
            before.add(point, point.weight);
        }
    }

    /// Pairs among points in the order of the first of three axes. Leaves them in that of the
    /// second.
    void splitFirst(Point* begin, Point* end) {
        if (end - begin <= kFew) {
            addPairs(begin, end, [](const Point&, const Point&) { return true; });
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
        splitSecondToLast(scratch_.data(), merged);
    }

    /// Pairs among points in the order of the axis before the last one; of three axes, only pairs
    /// of points of different halves along the first. Leaves them in the order of the last axis.
    Halves splitSecondToLast(Point* begin, Point* end) {
        if (end - begin <= kFew) {
            addPairs(begin, end,
                     [](const Point& a, const Point& b) { return Axes == 2 || a.half != b.half; });
            std::sort(begin, end, less<kLast>);
            Halves halves;
            for (; begin != end; ++begin) halves[begin->half].add(*begin, begin->weight);
            return halves;
        }
        Point* const middle = begin + (end - begin) / 2;
        Halves low = splitSecondToLast(begin, middle);
        const Halves high = splitSecondToLast(middle, end);
        addAcross(begin, middle, end, low);
        for (std::size_t half = 0; half < low.size(); ++half) low[half] += high[half];
        return low;
    }

    /// Pairs of a point before `middle` and one after, whose moments are `low`, and merges both by
    /// their last coordinates.
    void addAcross(Point* begin, Point* middle, Point* end, const Halves& low) {
        // Of the lower points, those that the last axis has behind the next point count as they
        // are, those in front of it have the other sign.
        Halves behindLessFront{-low[0], -low[1]};
        Point* to = spare_.data();
        Point* left = begin;
        for (Point* right = middle; right != end; ++right) {
            for (; left != middle && left->x[kLast] <= right->x[kLast]; ++left) {
                behindLessFront[left->half].add(*left, 2 * left->weight);
                *to++ = *left;
            }
            const bool otherSign = Axes == 3 && right->half == 0;
            const Moments<Axes>& partners = behindLessFront[Axes == 3 ? 1 - right->half : 0];
            const double products = right->weight * partners.products(right->x);
            sum_ += otherSign ? -products : products;
            *to++ = *right;
        }
        std::copy(left, middle, to);
        std::copy(spare_.data(), spare_.data() + (end - begin), begin);
    }

    template <class Count>
    void addPairs(const Point* begin, const Point* end, const Count& count) {
        double sum = 0;
        for (const Point* a = begin; a != end; ++a) {
            for (const Point* b = begin; b != a; ++b) {
                if (count(*a, *b)) sum += distanceProduct(*a, *b);
            }
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
    for (std::size_t k = 0; k < order.size(); ++k) {
        weighted[k].weight = weights[order[k]];
        for (unsigned d = 0; d < Axes; ++d) {
            weighted[k].x[d] = points.coordinate(axes[d])[order[k]];
        }
    }
    return 2 * PairSum<Axes>(std::move(weighted)).sum();
}

} // namespace

DistanceSums::DistanceSums(const UnitPoints& points) : points_(points), order_(points.dims()) {
    for (unsigned d = 0; d < points.dims(); ++d) {
        const double* x = points.coordinate(d);
        order_[d].resize(points.count());
        std::iota(order_[d].begin(), order_[d].end(), std::size_t{0});
        std::sort(order_[d].begin(), order_[d].end(),
                  [x](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    }
}

long double DistanceSums::sum(const std::vector<double>& weights,
                              const std::vector<unsigned>& axes) const {
    switch (axes.size()) {
    case 0: {
        const long double total = std::accumulate(weights.begin(), weights.end(), 0.0L);
        return total * total;
    }
    case 1: return pairSum<1>(points_, weights, axes, order_[axes[0]]);
    case 2: return pairSum<2>(points_, weights, axes, order_[axes[0]]);
    case 3: return pairSum<3>(points_, weights, axes, order_[axes[0]]);
    default: throw PointError("a product of distances has up to three axes");
    }
}

} // namespace stream1
} // namespace wellstrat
