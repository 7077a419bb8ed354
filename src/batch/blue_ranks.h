// SPDX-License-Identifier: Apache-2.0
//
// The lookups of blue batches, which vector code leaves to plain loops where registers cannot hold
// the table: single loads take less time than gather instructions
// (docs/decisions/0013-cheaper-draws.md), into which compilers would make these loops for newer
// targets.

#pragma once

#include "wellstrat/rank.h"

#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace batch {

/// Puts the rank of each of n places, given by `tile`, in its place.
void findRanks(std::size_t n, const uint16_t* tile, uint32_t* places);

/// The digits of the ranks of n places: of x in the lower and of y in the upper halves of xy, and
/// of z.
void findDigitsXY(std::size_t n, const uint16_t* tile, unsigned slot, const uint32_t* places,
                  uint64_t* xy);
void findDigitsZ(std::size_t n, const uint16_t* tile, unsigned slot, const uint32_t* places,
                 uint32_t* z);

/// The same digits of one dimension for registers of 2^kBits words: what each kBits bits of a rank
/// contribute by exclusive or.
template <unsigned kBits>
struct RankMap {
    alignas(64) uint32_t parts[kRankDigits / kBits][1u << kBits];
};

/// Those of x, y and z for a slot. kBits is 3 or 4.
template <unsigned kBits>
const RankMap<kBits>* rankMaps(unsigned slot);

} // namespace batch
} // namespace stream1
} // namespace wellstrat
