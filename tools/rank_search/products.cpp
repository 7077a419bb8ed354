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

std::vector<uint16_t> imagesOf(const RankColumns& columns) {
    std::vector<uint16_t> images{0};
    for (const uint16_t column : columns) bank::appendColumn(images, column);
    return images;
}

std::vector<uint16_t> placesOf(unsigned slot) {
    std::vector<uint16_t> places{0};
    for (unsigned k = 0; k < kRunDigits; ++k) bank::appendColumn(places, kJointBank[slot][k]);
    return places;
}

Products visited(const Products& products, const std::vector<uint16_t>& places,
                 const std::vector<uint16_t>& images) {
    Products result(products.size());
    for (std::size_t n = 0; n < kRun; ++n) {
        const double* const of = products.data() + std::size_t{places[n]} * kRanks;
        double* const to = result.data() + n * kRanks;
        for (std::size_t r = 0; r < kRanks; ++r) to[r] = of[images[r]];
    }
    return result;
}

} // namespace wellstrat::ranks
