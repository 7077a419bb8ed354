// SPDX-License-Identifier: Apache-2.0
#include "rank_search/products.h"

#include "bank_search/slot_order.h"
#include "wellstrat/bits.h"
#include "wellstrat/joint_bank.h"
#include "wellstrat/sobol.h"

#include <algorithm>

namespace wellstrat::ranks {
namespace {

/// The first binary digits that vanish, of those that spectra know.
unsigned sharedDigits(uint32_t digits) {
    return digits == 0 ? kLevels : std::min(trailingZeros(digits), kLevels);
}

using Digits = std::array<uint32_t, kRanks>;

Digits imagesOf(const RankMatrix& matrix) {
    Digits images{};
    for (unsigned q = 0; q < kRanks; ++q) images[q] = rankTimes(matrix, q);
    return images;
}

/// Calls `value` with the digits that points share in x, y and z.
template <typename Value>
Products products(const RankMatrix& rankZ, Value value) {
    static const Digits x = imagesOf(rankMatrix(0)), y = imagesOf(rankMatrix(1));
    const Digits z = imagesOf(rankZ);
    const SobolMatrix sobolZ = sobolMatrix(2);
    Products result;
    result.reserve(std::size_t{kRun} * kRanks);
    for (unsigned n = 0; n < kRun; ++n) {
        const uint32_t ofX = n, ofY = pascalTimes(n), ofZ = reverseBits(sobolSample(sobolZ, n));
        for (unsigned q = 0; q < kRanks; ++q) {
            result.push_back(value(sharedDigits(ofX ^ x[q]), sharedDigits(ofY ^ y[q]),
                                   sharedDigits(ofZ ^ z[q])));
        }
    }
    return result;
}

} // namespace

Products productsXY(const Spectrum2D& spectrum) {
    return productsXYZ(
        spectrum, [](unsigned k) { return k == 0 ? 1.0 : 0.0; }, RankMatrix{});
}

Products productsX(const Spectrum1D& spectrum) {
    const Products1D by(spectrum);
    return products(RankMatrix{},
                    [&](unsigned x, unsigned y, unsigned) { return (by.of[x] + by.of[y]) / 2; });
}

Products productsZ(const Spectrum1D& spectrum, const RankMatrix& rankZ) {
    const Products1D by(spectrum);
    return products(rankZ, [&](unsigned, unsigned, unsigned z) { return by.of[z]; });
}

Products productsXZ(const Spectrum2D& spectrum, const RankMatrix& rankZ) {
    const Products2D by(spectrum);
    return products(
        rankZ, [&](unsigned x, unsigned y, unsigned z) { return (by.of[x][z] + by.of[y][z]) / 2; });
}

Products productsXYZ(const Spectrum2D& ofXY, const Spectrum1D& ofZ, const RankMatrix& rankZ) {
    const Products2D by(ofXY);
    const Products1D byZ(ofZ);
    return products(rankZ, [&](unsigned x, unsigned y, unsigned z) {
        return (by.of[x][y] + by.of[y][x]) / 2 * byZ.of[z];
    });
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
