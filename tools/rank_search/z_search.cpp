// SPDX-License-Identifier: Apache-2.0
#include "rank_search/z_search.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace wellstrat::ranks {
namespace {

constexpr unsigned kRows = 32;

using Rows = std::vector<uint32_t>; // bit k is the element of column k

/// Whether the last `size` of the rows are independent in their first `size` columns.
bool lastAreIndependent(const Rows& rows, unsigned size) {
    Rows basis;
    for (std::size_t i = rows.size() - size; i < rows.size(); ++i) {
        uint32_t row = rows[i] & ((1u << size) - 1);
        for (const uint32_t other : basis) row = std::min(row, row ^ other);
        if (row == 0) return false;
        basis.push_back(row);
    }
    return true;
}

/// Whether all blocks that end in the last row are invertible.
bool lastFits(const Rows& rows) {
    for (unsigned size = 2; size <= kRankDigits && size <= rows.size(); size += 2) {
        if (!lastAreIndependent(rows, size)) return false;
    }
    return true;
}

/// Rows to columns.
RankMatrix matrixOf(const Rows& rows) {
    RankMatrix matrix{};
    for (unsigned r = 0; r < kRows; ++r) {
        for (unsigned k = 0; k < kRankDigits; ++k) {
            matrix.column[k] |= (rows[r] >> k & 1u) << r;
        }
    }
    return matrix;
}

/// The mean over k of the squared error with 2^k samples of a function with a mean of 1.
double meanError(const Products& products, const Weights& weights) {
    const double squaredMean = std::accumulate(weights.begin(), weights.end(), 0.0);
    double own = 0, all = 0, total = 0;
    std::size_t n = 0;
    for (unsigned k = 0; k <= kRunDigits; ++k) {
        for (; n < std::size_t{1} << k; ++n) {
            const auto row = products.begin() + static_cast<std::ptrdiff_t>(n * kRanks);
            own += *row;
            all = std::inner_product(weights.begin(), weights.end(), row, all);
        }
        const double count = static_cast<double>(n);
        total += (all / count - squaredMean) / (own / count - 1);
    }
    return total / (kRunDigits + 1);
}

} // namespace

bool stratifiesZ(const RankMatrix& matrix) {
    Rows rows;
    for (unsigned r = 0; r < kRows; ++r) {
        uint32_t row = 0;
        for (unsigned k = 0; k < kRankDigits; ++k) row |= (matrix.column[k] >> r & 1u) << k;
        rows.push_back(row);
        if (!lastFits(rows)) return false;
    }
    return true;
}

RankMatrix randomZ(std::mt19937& random) {
    constexpr unsigned kAttempts = 4000; // one row in 64 fits, unless none does
    for (;;) {
        Rows rows;
        while (rows.size() < kRows) {
            rows.push_back(0);
            unsigned attempt = 0;
            do rows.back() = static_cast<uint32_t>(random()) & (kRanks - 1);
            while (!lastFits(rows) && ++attempt < kAttempts);
            if (attempt == kAttempts) break;
        }
        if (rows.size() == kRows && lastFits(rows)) return matrixOf(rows);
    }
}

double meritOfZ(const RankMatrix& matrix, const Weights& weights) {
    return (meanError(productsXZ(edge, matrix), weights) +
            meanError(productsXYZ(smooth, smooth1D, matrix), weights)) /
           2;
}

RankMatrix searchZ(uint32_t seed, unsigned candidates) {
    std::mt19937 random(seed);
    const Weights weights = weightsOfRandomTiles();
    RankMatrix best{};
    double lowest = std::numeric_limits<double>::infinity();
    for (unsigned i = 0; i < candidates; ++i) {
        const RankMatrix matrix = randomZ(random);
        const double merit = meritOfZ(matrix, weights);
        if (merit >= lowest) continue;
        lowest = merit;
        best = matrix;
    }
    return best;
}

} // namespace wellstrat::ranks
