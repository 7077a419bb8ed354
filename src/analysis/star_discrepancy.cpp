// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/discrepancy.h"

#include "kinetic_tournament.h"

#include <algorithm>
#include <queue>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace {

double exactLine(const UnitPoints& points) {
    std::vector<double> x(points.coordinate(0), points.coordinate(0) + points.count());
    std::sort(x.begin(), x.end());
    const double count = static_cast<double>(x.size());
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double before = static_cast<double>(i) / count;
        const double after = static_cast<double>(i + 1) / count;
        largest = std::max({largest, after - x[i], x[i] - before});
    }
    return largest;
}

/// The values of a coordinate, each once, in order, and 1; and where each point's value stands.
struct Ranks {
    explicit Ranks(const double* x, std::size_t count) : values(x, x + count), of(count) {
        values.push_back(1);
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
        for (std::size_t i = 0; i < count; ++i) {
            const auto place = std::lower_bound(values.begin(), values.end(), x[i]);
            of[i] = static_cast<std::size_t>(place - values.begin());
        }
    }

    std::vector<double> values;
    std::vector<std::size_t> of;
};

/// Boxes in the first two coordinates, of all points or of those that `active(point)` picks. The
/// volume of a box is its area times `depth`. One tournament line stands for each y where a box may
/// end, and the sweep takes x through all places where it may.
class PlaneSweep {
public:
    explicit PlaneSweep(const UnitPoints& points)
        : x_(points.coordinate(0), points.count()), y_(points.coordinate(1), points.count()),
          byX_(points.count()), share_(1 / static_cast<double>(points.count())) {
        for (std::size_t i = 0; i < byX_.size(); ++i) byX_[i] = i;
        std::sort(byX_.begin(), byX_.end(),
                  [&](std::size_t a, std::size_t b) { return x_.of[a] < x_.of[b]; });
    }

    /// The largest share of points minus volume, over boxes with their upper borders.
    template <class Active>
    double excess(const Active& active, double depth) const {
        KineticTournament columns(slopes(-depth));
        double largest = 0;
        std::size_t next = 0;
        for (std::size_t rank = 0; rank < x_.values.size(); ++rank) {
            next = insert(next, rank, active, columns, 0, share_);
            largest = std::max(largest, columns.largest(x_.values[rank]));
        }
        return largest;
    }

    /// The largest volume minus share of points, over boxes without their upper borders.
    template <class Active>
    double deficit(const Active& active, double depth) const {
        KineticTournament columns(slopes(depth));
        double largest = 0;
        std::size_t next = 0;
        for (std::size_t rank = 0; rank < x_.values.size(); ++rank) {
            largest = std::max(largest, columns.largest(x_.values[rank]));
            next = insert(next, rank, active, columns, 1, -share_);
        }
        return largest;
    }

private:
    std::vector<double> slopes(double depth) const {
        std::vector<double> result = y_.values;
        for (double& slope : result) slope *= depth;
        return result;
    }

    /// Counts the points whose x has this rank in the boxes that end `above` places above theirs.
    template <class Active>
    std::size_t insert(std::size_t next, std::size_t rank, const Active& active,
                       KineticTournament& columns, std::size_t above, double height) const {
        for (; next < byX_.size() && x_.of[byX_[next]] == rank; ++next) {
            const std::size_t point = byX_[next];
            if (active(point)) columns.raiseFrom(y_.of[point] + above, height);
        }
        return next;
    }

    Ranks x_, y_;
    std::vector<std::size_t> byX_;
    double share_;
};

/// Halves slabs of the third coordinate, the one with the largest bound first.
class SlabSearch {
public:
    explicit SlabSearch(const UnitPoints& points)
        : plane_(points), z_(points.coordinate(2), points.count()) {
        // Boxes that end below the first point hold none; the first value stands for them too.
        if (z_.values.front() > 0) {
            z_.values.insert(z_.values.begin(), 0.0);
            for (std::size_t& rank : z_.of) ++rank;
        }
    }

    StarBounds search(std::size_t maxSweeps) {
        addSlab(0, z_.values.size() - 1);
        while (slabs_.top().bound > lower_ && sweeps_ + kSweepsOfHalving <= maxSweeps) {
            const Slab slab = slabs_.top();
            slabs_.pop();
            const std::size_t middle = (slab.from + slab.to) / 2;
            addSlab(slab.from, middle);
            addSlab(middle, slab.to);
        }
        return {lower_, std::max(lower_, slabs_.top().bound)};
    }

private:
    static constexpr std::size_t kSweepsOfHalving = 8;

    /// Boxes whose third side ends in [z(from), z(to)] (with the border) or (z(from), z(to)]
    /// (without it).
    struct Slab {
        double bound;
        std::size_t from, to;
        bool operator<(const Slab& other) const { return bound < other.bound; }
    };

    void addSlab(std::size_t from, std::size_t to) {
        const double low = z_.values[from];
        const double high = z_.values[to];
        const auto upToLow = [&](std::size_t point) { return z_.of[point] <= from; };
        const auto belowHigh = [&](std::size_t point) { return z_.of[point] < to; };
        const double excess = plane_.excess(upToLow, low);
        const double deficit = plane_.deficit(belowHigh, high);
        lower_ = std::max({lower_, excess, deficit});
        sweeps_ += 2;
        if (to == from + 1) {
            slabs_.push({std::max(excess, deficit), from, to});
            return;
        }
        sweeps_ += 2;
        const double excessBound = plane_.excess(belowHigh, low);
        const double deficitBound = plane_.deficit(upToLow, high);
        slabs_.push({std::max(excessBound, deficitBound), from, to});
    }

    PlaneSweep plane_;
    Ranks z_;
    std::priority_queue<Slab> slabs_;
    double lower_ = 0;
    std::size_t sweeps_ = 0;
};

StarBounds exactPlane(const UnitPoints& points) {
    const PlaneSweep plane(points);
    const auto all = [](std::size_t) { return true; };
    const double result = std::max(plane.excess(all, 1), plane.deficit(all, 1));
    return {result, result};
}

} // namespace

StarBounds starDiscrepancy(const UnitPoints& points, std::size_t maxSweeps) {
    switch (points.dims()) {
    case 1: {
        const double result = exactLine(points);
        return {result, result};
    }
    case 2: return exactPlane(points);
    case 3: return SlabSearch(points).search(maxSweeps);
    default: break;
    }
    throw PointError("the points have " + std::to_string(points.dims()) +
                     " dimensions; the star discrepancy is there for 1 to " +
                     std::to_string(kMaxStarDimensions));
}

} // namespace stream1
} // namespace wellstrat
