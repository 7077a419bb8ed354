// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/independence.h"

#include "chi_square.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// A coordinate of a stream, made ready for all its pairs.
struct PreparedCoordinate {
    PreparedCoordinate(const double* x, std::size_t count, unsigned gridSide)
        : centered(x, x + count), cells(count), cellCounts(gridSide) {
        double mean = 0;
        for (const double value : centered) mean += value / static_cast<double>(count);
        double squares = 0;
        for (double& value : centered) {
            value -= mean;
            squares += value * value;
        }
        const double scale = squares > 0 ? 1 / std::sqrt(squares) : 0;
        for (double& value : centered) value *= scale;
        for (std::size_t i = 0; i < count; ++i) {
            // The product may round up to the side.
            cells[i] = std::min(static_cast<uint32_t>(x[i] * gridSide), gridSide - 1);
            ++cellCounts[cells[i]];
        }
        for (const double n : cellCounts) logOrders += std::lgamma(n + 1);
    }

    std::vector<double> centered; ///< mean 0, sum of squares 1
    std::vector<uint32_t> cells;
    std::vector<double> cellCounts;
    double logOrders = 0; ///< log of the product of cellCounts[k]!
};

double correlation(const PreparedCoordinate& a, const PreparedCoordinate& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.centered.size(); ++i) sum += a.centered[i] * b.centered[i];
    return sum;
}

double degreesOf(const PreparedCoordinate& coordinate) {
    const auto empty = std::count(coordinate.cellCounts.begin(), coordinate.cellCounts.end(), 0.0);
    return static_cast<double>(coordinate.cellCounts.size()) - 1 - static_cast<double>(empty);
}

class PairTester {
public:
    PairTester(std::size_t count, unsigned gridSide)
        : count_(static_cast<double>(count)), counts_(std::size_t{gridSide} * gridSide) {}

    void test(const PreparedCoordinate& a, const PreparedCoordinate& b, CoordinatePair& pair) {
        pair.correlation = correlation(a, b);
        pair.correlationProbability =
            std::erfc(std::fabs(pair.correlation) * std::sqrt((count_ - 1) / 2));
        pair.chiSquare = pair.chiSquareProbability = 1;
        const double degrees = degreesOf(a) * degreesOf(b);
        if (degrees == 0) return;
        const double chiSquare = chiSquareOf(a, b);
        Tails tails = chiSquareTails(chiSquare, degrees);
        if (tails.below < tails.above) {
            tails.below = std::max(tails.below, probabilityOfCounts(a, b));
        }
        pair.chiSquare = chiSquare / degrees;
        pair.chiSquareProbability = std::min(1.0, 2 * std::min(tails.below, tails.above));
    }

private:
    double chiSquareOf(const PreparedCoordinate& a, const PreparedCoordinate& b) {
        const std::size_t side = a.cellCounts.size();
        std::fill(counts_.begin(), counts_.end(), 0u);
        for (std::size_t i = 0; i < a.cells.size(); ++i) ++counts_[a.cells[i] * side + b.cells[i]];
        double sum = 0;
        for (std::size_t row = 0; row < side; ++row) {
            for (std::size_t column = 0; column < side; ++column) {
                const double expected = a.cellCounts[row] * b.cellCounts[column] / count_;
                const double off = counts_[row * side + column] - expected;
                if (expected > 0) sum += off * off / expected;
            }
        }
        return sum;
    }

    /// Of exactly these counts, whose rows and columns are given (Fisher 1922).
    double probabilityOfCounts(const PreparedCoordinate& a, const PreparedCoordinate& b) const {
        double log = a.logOrders + b.logOrders - std::lgamma(count_ + 1);
        for (const uint32_t n : counts_) log -= std::lgamma(n + 1.0);
        return std::exp(log);
    }

    double count_;
    std::vector<uint32_t> counts_;
};

void checkStreams(const std::vector<SampleStream>& streams, unsigned gridSide) {
    if (streams.size() < 2) throw PointError("independence is that of two streams or more");
    const std::size_t count = streams.front().points.count();
    for (const SampleStream& stream : streams) {
        if (stream.points.count() != count) {
            throw PointError("the streams have different numbers of points");
        }
    }
    if (count < 3) throw PointError("independence needs three points or more");
    if (gridSide < 2 || gridSide > 1024) {
        throw PointError("the side of the grid is " + std::to_string(gridSide) +
                         "; accepted are 2 to 1024");
    }
}

/// The coordinates of each stream.
std::vector<std::vector<PreparedCoordinate>> prepare(const std::vector<SampleStream>& streams,
                                                     unsigned gridSide) {
    std::vector<std::vector<PreparedCoordinate>> prepared(streams.size());
    for (std::size_t s = 0; s < streams.size(); ++s) {
        const UnitPoints& points = streams[s].points;
        for (unsigned d = 0; d < points.dims(); ++d) {
            prepared[s].emplace_back(points.coordinate(d), points.count(), gridSide);
        }
    }
    return prepared;
}

/// Adds a pair and leaves out the least unlikely one if there are too many.
void keepWorst(std::vector<CoordinatePair>& worst, std::size_t limit, const CoordinatePair& pair) {
    const auto lessLikely = [](const CoordinatePair& a, const CoordinatePair& b) {
        return std::pair(a.probability(), -std::fabs(a.correlation)) <
               std::pair(b.probability(), -std::fabs(b.correlation));
    };
    worst.insert(std::upper_bound(worst.begin(), worst.end(), pair, lessLikely), pair);
    if (worst.size() > limit) worst.pop_back();
}

} // namespace

double CoordinatePair::probability() const {
    return std::min(1.0, 2 * std::min(correlationProbability, chiSquareProbability));
}

double IndependenceReport::probability() const {
    if (worst.empty()) return 1;
    return std::min(1.0, static_cast<double>(pairs) * worst.front().probability());
}

IndependenceReport testIndependence(const std::vector<SampleStream>& streams, unsigned gridSide,
                                    std::size_t worstCount) {
    checkStreams(streams, gridSide);
    const std::size_t count = streams.front().points.count();
    const auto coordinates = prepare(streams, gridSide);
    PairTester tester(count, gridSide);
    IndependenceReport report;
    double squares = 0;
    CoordinatePair pair{};
    for (pair.first = 0; pair.first < streams.size(); ++pair.first) {
        for (pair.second = pair.first + 1; pair.second < streams.size(); ++pair.second) {
            for (pair.firstDim = 0; pair.firstDim < coordinates[pair.first].size();
                 ++pair.firstDim) {
                for (pair.secondDim = 0; pair.secondDim < coordinates[pair.second].size();
                     ++pair.secondDim) {
                    tester.test(coordinates[pair.first][pair.firstDim],
                                coordinates[pair.second][pair.secondDim], pair);
                    ++report.pairs;
                    squares += pair.correlation * pair.correlation;
                    report.meanChiSquare += pair.chiSquare;
                    keepWorst(report.worst, worstCount, pair);
                }
            }
        }
    }
    const auto pairs = static_cast<double>(report.pairs);
    report.correlationSpread = std::sqrt(squares / pairs * (static_cast<double>(count) - 1));
    report.meanChiSquare /= pairs;
    return report;
}

unsigned usualGridSide(std::size_t count) {
    unsigned side = 2;
    while (side < 32 && std::size_t{4} * side * side * 8 <= count) side *= 2;
    return side;
}

} // namespace stream1
} // namespace wellstrat
