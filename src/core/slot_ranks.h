// SPDX-License-Identifier: Apache-2.0
//
// What the rank of a pixel adds to the points of a slot.

#pragma once

#include "wellstrat/blue_tables.h"
#include "wellstrat/rank.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// The matrix Dx V_d, Dy V_d or Dz V_d of slot d: see rankMatrix and kRankBank.
constexpr RankMatrix slotRankMatrix(unsigned dimension, unsigned slot) {
    const RankMatrix ofSlot = rankMatrix(dimension);
    RankMatrix ofPixel{};
    for (unsigned k = 0; k < kRankDigits; ++k) {
        ofPixel.column[k] = rankTimes(ofSlot, kRankBank[slot][k]);
    }
    return ofPixel;
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
