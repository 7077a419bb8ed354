// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/blue_tables.h"

#include "wellstrat/blue_lookup.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {
namespace {

/// Multiplies polynomials over GF(2) by 1 + z + z^2.
constexpr uint32_t timesTrinomial(uint32_t f) { return f ^ f << 1 ^ f << 2; }

/// Both numerators N of sum (q_2l + q_2l+1 z) / (1 + z + z^2)^(l+1) over the eighth power.
constexpr RankWord rankWord(uint32_t rank) {
    uint32_t numerator = 0;
    for (unsigned bit = 0; bit < kRankDigits; bit += 2) {
        numerator = timesTrinomial(numerator) ^ (rank >> bit & 3u);
    }
    for (unsigned level = kRankDigits / 2; level < 8; ++level) {
        numerator = timesTrinomial(numerator);
    }
    return numerator | pascalTimes(numerator) << 16; // N(z + 1) by Pascal's triangle
}

/// The digits of z of the rank whose word has these bits 4 to 15. They determine it: bit 11 - p is
/// the highest that rank bit p ^ 1 contributes to.
constexpr uint32_t rankDigitsZ(uint32_t bits) {
    uint32_t digits = 0;
    for (unsigned p = 0; p < kRankDigits; ++p) {
        if ((bits >> (11 - p) & 1u) == 0) continue;
        bits ^= rankWord(1u << (p ^ 1u)) >> 4 & 0xfffu;
        digits ^= rankMatrix(2).column[p ^ 1u];
    }
    return digits;
}

constexpr uint32_t times(const uint16_t* columns, uint32_t bits) {
    uint32_t product = 0;
    for (unsigned b = 0; b < kRankDigits; ++b) {
        if (bits >> b & 1u) product ^= columns[b];
    }
    return product;
}

/// The linear map from what it makes of each six bits.
template <typename Function>
constexpr LinearMap makeMap(Function map) {
    LinearMap result{};
    for (uint32_t bits = 0; bits < 64; ++bits) {
        result.of[0][bits] = map(bits);
        result.of[1][bits] = map(bits << 6);
    }
    return result;
}

constexpr BlueTables makeTables() {
    BlueTables tables{};
    const LinearMap word = makeMap(rankWord);
    for (unsigned place = 0; place < kRanks; ++place) {
        tables.padded[place] = word(kRankTilePadded[place]);
        tables.slots[place] = kRankTileSlots[place];
    }
    for (unsigned slot = 0; slot < kJointSlots; ++slot) {
        const auto rank = [&](uint32_t bits) { return word(times(kRankBank[slot], bits)); };
        tables.rank[slot] = makeMap(rank);
    }
    tables.z = makeMap(rankDigitsZ);
    return tables;
}

} // namespace

constexpr BlueTables kBlueTables = makeTables();

static_assert(sizeof(BlueTables) <= 34 * 1024, "small enough for any cache");

} // namespace detail
} // namespace stream1
} // namespace wellstrat
