// SPDX-License-Identifier: Apache-2.0
#include "rank_search/products.h"

#include "wellstrat/bits.h"
#include "wellstrat/joint_bank.h"
#include "wellstrat/sobol.h"

#include <algorithm>

namespace wellstrat::ranks {
namespace {

/// The first binary digits that vanish, of those that spectra know.
unsigned sharedDigits(uint32_t digits) {
    return digits == 0 ? bank::kDigits : std::min(trailingZeros(digits), bank::kDigits);
}

/// Calls `value` with the digits that points share in x, y and z.
template <typename Value>
Products products(Value value) {
    const RankMatrix rankX = rankMatrix(0), rankY = rankMatrix(1), rankZ = rankMatrix(2);
    const SobolMatrix sobolZ = sobolMatrix(2);
    Products result;
    result.reserve(std::size_t{kRun} * kRanks);
    for (unsigned n = 0; n < kRun; ++n) {
        for (unsigned q = 0; q < kRanks; ++q) {
            result.push_back(
                value(sharedDigits(n ^ rankTimes(rankX, q)),
                      sharedDigits(pascalTimes(n) ^ rankTimes(rankY, q)),
                      sharedDigits(reverseBits(sobolSample(sobolZ, n)) ^ rankTimes(rankZ, q))));
        }
    }
    return result;
}

} // namespace

Products productsXY(const bank::Spectrum2D& spectrum) {
    const bank::ProductsByDigits2D by = bank::productsByDigits(spectrum);
    return products(
        [&](unsigned x, unsigned y, unsigned) { return (by.of[x][y] + by.of[y][x]) / 2; });
}

Products productsX(const bank::Spectrum1D& spectrum) {
    const bank::ProductsByDigits1D by = bank::productsByDigits(spectrum);
    return products([&](unsigned x, unsigned y, unsigned) { return (by.of[x] + by.of[y]) / 2; });
}

Products productsZ(const bank::Spectrum1D& spectrum) {
    const bank::ProductsByDigits1D by = bank::productsByDigits(spectrum);
    return products([&](unsigned, unsigned, unsigned z) { return by.of[z]; });
}

Visits visitsOf(unsigned slot, const RankColumns& columns) {
    Visits visits{{0}, {0}};
    for (unsigned k = 0; k < kRunDigits; ++k) {
        bank::appendColumn(visits.places, kJointBank[slot][k]);
    }
    for (const uint16_t column : columns) bank::appendColumn(visits.images, column);
    return visits;
}

RankColumns identityColumns() {
    RankColumns columns{};
    for (unsigned k = 0; k < kRankDigits; ++k) columns[k] = static_cast<uint16_t>(1u << k);
    return columns;
}

} // namespace wellstrat::ranks
