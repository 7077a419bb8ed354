// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/independence.h"

#include "chi_square.h"
#include "nested_order.h"

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
        places = nestedPlaces(cells, gridSide);
        levels = orderLevels(centered);
    }

    std::vector<double> centered; ///< mean 0, sum of squares 1
    std::vector<uint32_t> cells;
    std::vector<double> cellCounts;
    double logOrders = 0;           ///< log of the product of cellCounts[k]!
    std::vector<uint32_t> places;   ///< of nested order, or nothing
    std::vector<OrderLevel> levels; ///< of `centered`
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

/// Counts in cells against what they should be, and how likely they are.
struct CountTest {
    double chiSquare, degrees;
    Tails tails;
};

class PairTester {
public:
    PairTester(std::size_t count, unsigned gridSide)
        : count_(static_cast<double>(count)), side_(gridSide) {}

    void test(const PreparedCoordinate& a, const PreparedCoordinate& b,
              CoordinatePair& pair) const {
        pair.correlation = correlation(a, b);
        pair.correlationDeviation = std::sqrt(productVariance(a.levels, b.levels));
        pair.correlationProbability =
            std::erfc(std::fabs(pair.correlation) / std::max(pair.correlationDeviation, kRounding) /
                      std::sqrt(2.0));
        const bool areNested = !a.places.empty() && !b.places.empty();
        const CountTest found = areNested ? testCoins(a, b) : testTable(a, b);
        pair.chiSquare = found.degrees > 0 ? found.chiSquare / found.degrees : 1;
        pair.chiSquareProbability =
            std::min(1.0, 2 * std::min(found.tails.below, found.tails.above));
    }

private:
    static constexpr double kRounding = 1e-12; ///< of correlations, and more

    std::vector<uint32_t> counts(const std::vector<uint32_t>& rows,
                                 const std::vector<uint32_t>& columns) const {
        std::vector<uint32_t> counts(side_ * side_);
        for (std::size_t i = 0; i < rows.size(); ++i) ++counts[rows[i] * side_ + columns[i]];
        return counts;
    }

    /// Two nested orders.
    CountTest testCoins(const PreparedCoordinate& a, const PreparedCoordinate& b) const {
        const CoinCounts coins = coinCounts(counts(a.places, b.places), side_);
        Tails tails = chiSquareTails(coins.chiSquare, coins.degrees);
        const double exactly = std::exp(coins.logProbability);
        return {coins.chiSquare,
                coins.degrees,
                {std::max(tails.below, exactly), std::max(tails.above, exactly)}};
    }

    /// A contingency table: two orders of which at least one is any order.
    CountTest testTable(const PreparedCoordinate& a, const PreparedCoordinate& b) const {
        const double degrees = degreesOf(a) * degreesOf(b);
        if (degrees == 0) return {0, 0, {1, 1}};
        const std::vector<uint32_t> table = counts(a.cells, b.cells);
        const double chiSquare = chiSquareOf(table, a, b);
        Tails tails = chiSquareTails(chiSquare, degrees);
        if (tails.below < tails.above) {
            tails.below = std::max(tails.below, probabilityOfCounts(table, a, b));
        }
        return {chiSquare, degrees, tails};
    }

    double chiSquareOf(const std::vector<uint32_t>& table, const PreparedCoordinate& a,
                       const PreparedCoordinate& b) const {
        double sum = 0;
        for (std::size_t row = 0; row < side_; ++row) {
            for (std::size_t column = 0; column < side_; ++column) {
                const double expected = a.cellCounts[row] * b.cellCounts[column] / count_;
                const double off = table[row * side_ + column] - expected;
                if (expected > 0) sum += off * off / expected;
            }
        }
        return sum;
    }

    /// Of exactly these counts, whose rows and columns are given (Fisher 1922).
    double probabilityOfCounts(const std::vector<uint32_t>& table, const PreparedCoordinate& a,
                               const PreparedCoordinate& b) const {
        double log = a.logOrders + b.logOrders - std::lgamma(count_ + 1);
        for (const uint32_t n : table) log -= std::lgamma(n + 1.0);
        return std::exp(log);
    }

    double count_;
    std::size_t side_;
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
    const auto coordinates = prepare(streams, gridSide);
    const PairTester tester(streams.front().points.count(), gridSide);
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
                    if (pair.correlationDeviation > 0) {
                        squares += std::pow(pair.correlation / pair.correlationDeviation, 2);
                    }
                    report.meanChiSquare += pair.chiSquare;
                    keepWorst(report.worst, worstCount, pair);
                }
            }
        }
    }
    const auto pairs = static_cast<double>(report.pairs);
    report.correlationSpread = std::sqrt(squares / pairs);
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
