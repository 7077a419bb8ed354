// SPDX-License-Identifier: Apache-2.0
//
// Two tests of random words by George Marsaglia. Each takes a function from index to a 32-bit word
// that should be uniform and independent, and returns how probable a result at least as unlikely
// is.

#pragma once

#include "statistical/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace statistical {

/// Birthday spacings: equal distances between neighbors among 4096 birthdays in a year of 2^32
/// days, of which 4096^3 / 2^34 = 4 are expected; in 256 years. Their sum is Poisson, near enough
/// normal at 6 sigma. Takes 2^20 words.
/// Marsaglia 1985, "A current view of random number generators"; parameters after L'Ecuyer and
/// Simard 2001, "On the performance of birthday spacings tests with certain families of random
/// number generators".
template <typename Word>
double birthdaySpacingsP(Word word) {
    constexpr uint32_t kBirthdays = 4096, kYears = 256;
    constexpr double kExpected = 4.0 * kYears;
    uint32_t repeats = 0;
    std::vector<uint32_t> days(kBirthdays);
    for (uint32_t year = 0; year < kYears; ++year) {
        for (uint32_t i = 0; i < kBirthdays; ++i) days[i] = word(year * kBirthdays + i);
        std::sort(days.begin(), days.end());
        for (uint32_t i = kBirthdays - 1; i > 0; --i) days[i] -= days[i - 1];
        std::sort(days.begin() + 1, days.end());
        for (uint32_t i = 2; i < kBirthdays; ++i) repeats += days[i] == days[i - 1];
    }
    return normalTail((repeats - kExpected) / std::sqrt(kExpected));
}

inline unsigned rankOverGF2(uint32_t rows[32]) {
    unsigned rank = 0;
    for (uint32_t bit = 1; bit != 0; bit <<= 1) {
        unsigned pivot = rank;
        while (pivot < 32 && !(rows[pivot] & bit)) ++pivot;
        if (pivot == 32) continue;
        std::swap(rows[rank], rows[pivot]);
        for (unsigned r = pivot + 1; r < 32; ++r) {
            if (rows[r] & bit) rows[r] ^= rows[rank];
        }
        ++rank;
    }
    return rank;
}

/// The probability that a random n x n matrix over GF(2) has this rank.
inline double rankProbability(int rank, int n) {
    double p = std::exp2(rank * (2 * n - rank) - n * n);
    for (int i = 0; i < rank; ++i) {
        p *= std::pow(1 - std::exp2(i - n), 2) / (1 - std::exp2(i - rank));
    }
    return p;
}

/// The ranks over GF(2) of 2^15 matrices, each of 32 words in a row.
/// Marsaglia and Tsay 1985, "Matrices and the structure of random number sequences".
template <typename Word>
double matrixRankP(Word word) {
    constexpr uint32_t kMatrices = 1u << 15;
    std::vector<uint32_t> counts(4); // 32, 31, 30, less
    uint32_t rows[32];
    for (uint32_t m = 0; m < kMatrices; ++m) {
        for (uint32_t r = 0; r < 32; ++r) rows[r] = word(m * 32 + r);
        ++counts[std::min(32 - rankOverGF2(rows), 3u)];
    }
    std::vector<double> expected(4, kMatrices);
    for (int i = 0; i < 3; ++i) {
        expected[static_cast<unsigned>(i)] = kMatrices * rankProbability(32 - i, 32);
        expected[3] -= expected[static_cast<unsigned>(i)];
    }
    return chiSquareP(counts, expected);
}

} // namespace statistical
