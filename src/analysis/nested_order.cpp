// SPDX-License-Identifier: Apache-2.0

#include "nested_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// Whether `places`, one for each index of a block, is a nested shuffle: parts come to be parts.
bool isNestedShuffle(const uint32_t* places, unsigned side) {
    for (unsigned part = 2; part < side; part *= 2) {
        for (unsigned i = 0; i < side; ++i) {
            if (places[i] / part != places[i / part * part] / part) return false;
        }
    }
    return true;
}

void addCoins(uint32_t heads, uint32_t tails, CoinCounts& found) {
    const double coins = double(heads) + tails;
    if (coins == 0) return;
    const double off = double(heads) - tails;
    found.chiSquare += off * off / coins;
    found.degrees += 1;
    found.logProbability += std::lgamma(coins + 1) - std::lgamma(heads + 1.0) -
                            std::lgamma(tails + 1.0) - coins * std::log(2.0);
}

} // namespace

std::vector<OrderLevel> orderLevels(std::vector<double> values) {
    std::vector<OrderLevel> levels;
    double points = 1; // that each value is the sum of
    while (values.size() % 2 == 0) {
        const std::size_t pairs = values.size() / 2;
        OrderLevel level{0, static_cast<double>(pairs)};
        for (std::size_t i = 0; i < pairs; ++i) {
            const double difference = values[2 * i] - values[2 * i + 1];
            level.energy += difference * difference / (2 * points);
            values[i] = values[2 * i] + values[2 * i + 1];
        }
        levels.push_back(level);
        values.resize(pairs);
        points *= 2;
    }
    OrderLevel rest{0, static_cast<double>(values.size() - 1)};
    for (const double value : values) rest.energy += value * value / points;
    if (rest.dims > 0) levels.push_back(rest);
    return levels;
}

double productVariance(const std::vector<OrderLevel>& a, const std::vector<OrderLevel>& b) {
    double variance = 0;
    for (std::size_t l = 0; l < a.size(); ++l) variance += a[l].energy * b[l].energy / a[l].dims;
    return variance;
}

std::vector<uint32_t> nestedPlaces(const std::vector<uint32_t>& cells, unsigned side) {
    if ((side & (side - 1)) != 0 || cells.size() % side != 0) return {};
    std::vector<uint32_t> placeOfCell(side, side), places(cells.size());
    for (unsigned i = 0; i < side; ++i) placeOfCell[cells[i]] = i;
    std::vector<std::size_t> lastBlock(side, std::numeric_limits<std::size_t>::max());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        places[i] = placeOfCell[cells[i]];
        if (places[i] == side || lastBlock[places[i]] == i / side) return {};
        lastBlock[places[i]] = i / side;
    }
    for (std::size_t first = 0; first < places.size(); first += side) {
        if (!isNestedShuffle(&places[first], side)) return {};
    }
    return places;
}

CoinCounts coinCounts(std::vector<uint32_t> counts, std::size_t side) {
    CoinCounts found;
    // Of each part, a block that comes to it has as many points as the part has rows.
    for (uint32_t points = 2; side > 1; points *= 2) {
        const std::size_t half = side / 2;
        for (std::size_t row = 0; row < half; ++row) {
            for (std::size_t column = 0; column < half; ++column) {
                const uint32_t* const upper = &counts[2 * row * side + 2 * column];
                const uint32_t* const lower = upper + side;
                const uint32_t kept = upper[0] + lower[1], swapped = upper[1] + lower[0];
                addCoins(kept / points, swapped / points, found);
                counts[row * half + column] = kept + swapped;
            }
        }
        side = half;
    }
    return found;
}

} // namespace stream1
} // namespace wellstrat
