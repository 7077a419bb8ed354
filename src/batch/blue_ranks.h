// SPDX-License-Identifier: Apache-2.0
//
// The lookups of blue batches, which vector code leaves to plain loops: single loads take less time
// than gather instructions (docs/decisions/0013-cheaper-draws.md), into which compilers would make
// these loops for newer targets.

#pragma once

#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace batch {

/// Puts the rank word of each of n places of the padded tile in its place.
void paddedRanks(std::size_t n, uint32_t* places);
/// The same for a slot.
void slotRanks(std::size_t n, unsigned slot, uint32_t* places);
/// The digits of z of n rank words.
void rankDigitsZ(std::size_t n, const uint32_t* ranks, uint32_t* digits);

} // namespace batch
} // namespace stream1
} // namespace wellstrat
